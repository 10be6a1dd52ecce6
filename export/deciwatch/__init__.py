"""DeciWatch's torch half: nets, training, evaluation, ONNX export, FLOPs, data preparation."""
