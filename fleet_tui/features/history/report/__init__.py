"""The report of a shift: one page of HTML, with its pictures as SVG."""
