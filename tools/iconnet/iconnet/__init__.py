"""A small joint network of pictures and words, trained on icons and on wires made of them."""
