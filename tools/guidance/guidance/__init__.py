"""Pictures and words to gradients: exports frozen networks as plain ONNX graphs that any runtime can run."""
