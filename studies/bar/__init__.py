"""The bar of a scene: its description, mesh, outline and the lengths that are read off the outline."""
