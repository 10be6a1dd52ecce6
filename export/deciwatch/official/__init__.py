"""Nets in the format that DeciWatch's authors publish: read, run as our two graphs, written.

What is known of the format, and from where, stands in export/README.md. Only its facts are used
here, none of its authors' code.
"""
