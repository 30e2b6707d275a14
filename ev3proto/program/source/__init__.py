"""Sources of programs (.lms): both dialects to images, and images to the strict dialect."""
