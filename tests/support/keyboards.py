"""Printable ASCII characters that need AltGr or a dead key, by layout: from the compiled symbols of xkb-data,
the default variant of each layout, levels without AltGr."""

NEEDS_ALTGR = {
    "German": frozenset(r"@[\]^`{|}~"),
    "French": frozenset(r"#@[\]^`{|}"),
    "Spanish": frozenset(r"#@[\]^`{|}~"),
    "Portuguese": frozenset(r"@[]^`{}~"),
}
