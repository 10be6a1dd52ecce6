import type { InstancedMesh } from 'three';

/** Says that the places and colours of a mesh's instances have been written anew. */
export function instancesChanged(mesh: InstancedMesh): void {
  mesh.instanceMatrix.needsUpdate = true;
  if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
}
