"""How Sphinx makes the site; docs/site/make starts it."""

project = "isotouch"
author = "the isotouch maintainers"
extensions = ["myst_parser"]
root_doc = "index"
myst_heading_anchors = 4  # headings are linked to as on the pages of a repository
html_theme = "alabaster"
html_theme_options = {"page_width": "75rem", "sidebar_width": "17rem", "fixed_sidebar": True, "show_powered_by": False}
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_copy_source = False
html_show_sourcelink = False
html_last_updated_fmt = None
suppress_warnings = ["myst.header"]  # a page of answers has one heading only
