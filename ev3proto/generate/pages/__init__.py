"""The reference pages of the documentation: Markdown that a code host shows as it is, and that Sphinx builds."""
