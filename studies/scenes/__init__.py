"""The scene: what to simulate, as data and as XML; beside it the scenes that come with matpoint."""
