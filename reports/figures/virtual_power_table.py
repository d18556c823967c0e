"""Table 5.1: the nine products of virtual and actual kinematic quantities, each checked by numbers."""

HEADS = ("virtual velocity", "acceleration of", "their product over the mass", "largest difference, relative", "in the last draw: summed", "closed form")


def table(inputs):
    rows = inputs.table("virtual-power")
    if rows is None:
        return {"heads": ["not measured in this run"], "rows": []}
    return {"heads": HEADS, "rows": [[r["virtual"], r["actual"], r["form"], f"{r['worst']:.1e}", f"{r['sum']:.6g}" if r["form"] != "0" else f"{r['sum']:.0e}",
                                      f"{r['closed']:.6g}"] for r in rows]}
