"""The style of a report, on a screen and on paper."""

CSS = """
:root { color-scheme: light; }
body { font: 14px/1.45 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; color: #1d2733; background: #fff;
  max-width: 1000px; margin: 24px auto; padding: 0 20px; }
h1 { font-size: 24px; margin: 0 0 2px; }
h2 { font-size: 16px; margin: 28px 0 8px; border-bottom: 1px solid #cfd6de; padding-bottom: 3px; }
.about, figcaption, .legend, .none { color: #56616d; }
.warning { background: #fff4d6; border-left: 4px solid #c98a00; padding: 6px 10px; }
.tiles { display: flex; flex-wrap: wrap; gap: 8px; margin: 16px 0; }
.tiles div { flex: 1 1 110px; border: 1px solid #cfd6de; border-radius: 6px; padding: 8px 10px; }
.tiles b { display: block; font-size: 22px; line-height: 1.2; }
.tiles .bad b::before { content: "\\25b2\\00a0"; font-size: 15px; }
.tiles .bad b { color: #a61b1b; }
.notes p { border-left: 4px solid #2f6fb3; margin: 6px 0; padding: 2px 10px; white-space: pre-wrap;
  overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 3px 8px; border-bottom: 1px solid #e6eaee; overflow-wrap: anywhere; }
th { color: #56616d; font-weight: 600; }
.n { text-align: right; white-space: nowrap; overflow-wrap: normal; }
svg { display: block; width: 100%; height: auto; }
svg text { font: 11px system-ui, "DejaVu Sans", sans-serif; fill: #3a4552; }
.mark { stroke: #e1e6eb; fill: none; }
.driving { stroke: #2e8b57; } .loading { stroke: #2f6fb3; } .waiting { stroke: #b8860b; }
.charging { stroke: #1f9aa8; } .idle { stroke: #8a95a1; } .paused { stroke: #7d5bb5; }
.blocked { stroke: #c22f2f; } .offline { stroke: #59626c; stroke-dasharray: 1.5 1.5; }
.legend span { display: inline-flex; align-items: center; gap: 5px; margin-right: 14px; }
.legend svg { width: 22px; height: 16px; }
.small { display: grid; grid-template-columns: repeat(auto-fill, minmax(150px, 1fr)); gap: 10px; }
figure { margin: 0; } .small svg { border: 1px solid #e1e6eb; }
.curve { stroke: #1f6f5c; stroke-width: 1.5; fill: none; stroke-linejoin: round; }
.limit { stroke: #c22f2f; stroke-width: .7; stroke-dasharray: 3 3; fill: none; }
.floors { display: grid; grid-template-columns: repeat(auto-fit, minmax(380px, 1fr)); gap: 14px; }
.floor { border: 1px solid #cfd6de; max-height: 520px; }
.heat { fill: #d1341f; fill-opacity: .45; stroke: #8f1d0d; stroke-width: 1; }
.floor text { font-size: inherit; fill: #5c1207; font-weight: 600; }
@page { size: A4; margin: 14mm; }
@media print { body { margin: 0; max-width: none; padding: 0; font-size: 11px; }
  h2 { break-after: avoid; } tr, figure, .tiles div { break-inside: avoid; }
  thead { display: table-header-group; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
"""
