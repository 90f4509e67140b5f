"""The bar of a scene: its description, mesh and outline, and what is measured on it in a Taylor impact."""
