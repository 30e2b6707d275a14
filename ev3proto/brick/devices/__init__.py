"""Models of what a brick is made of beside its machine: motors, sensors, display, buttons, loudspeaker, terminal."""
