"""The version, where the build finds it without importing the rest."""

VERSION = "0.2.0"
