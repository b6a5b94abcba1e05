"""The map as characters and style roles: scene, layers, camera."""
