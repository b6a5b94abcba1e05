"""The history: its pages, notes, reports, figures for Prometheus, and the way into recordings."""
