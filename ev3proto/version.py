"""The version, where the build finds it without importing the rest."""

VERSION = "0.1.0"
