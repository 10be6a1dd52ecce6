import { engineFiles } from '../../web/engine/files.ts';
import { setRuntimeFiles } from '../../web/recovery/runtime.ts';

// The engine says this to its worker; tests that run nets themselves have none.
setRuntimeFiles(engineFiles().runtime);
