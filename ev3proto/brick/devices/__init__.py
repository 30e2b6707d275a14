"""Models of a brick's parts besides its machine: motors, sensors, display, buttons, loudspeaker, terminal."""
