"""Training and evaluation data: windows of motion, cameras, estimator noise, batches."""
