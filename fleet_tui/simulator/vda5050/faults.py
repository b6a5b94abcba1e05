"""Faults of simulated vehicles: each changes one of them from the beginning."""

from collections.abc import Callable, Mapping

from fleet_tui.simulator.vda5050.vehicle import SimVehicle

MOTOR = {
    "errorType": "motorError",
    "errorLevel": "FATAL",
    "errorDescription": "drive too hot",
    "errorHint": "let it cool down, then switch it off and on",
    "errorReferences": [],
}


def _set(**values: object) -> Callable[[SimVehicle], None]:
    """Return a fault that sets attributes."""

    def apply(vehicle: SimVehicle) -> None:
        for name, value in values.items():
            setattr(vehicle, name, value)

    return apply


def _motor(vehicle: SimVehicle) -> None:
    vehicle.errors.append(dict(MOTOR))


FAULTS: Mapping[str, tuple[str, Callable[[SimVehicle], None]]] = {
    "refuse": ("all orders are rejected", _set(rejects=True)),
    "silent": ("connected, and sends nothing", _set(silent=True)),
    "e-stop": ("its emergency stop is pressed", _set(e_stop="MANUAL")),
    "obstacle": ("its protective field is violated", _set(field=True)),
    "manual": ("in manual mode: takes no orders", _set(mode="MANUAL")),
    "motor": ("a fatal error with a hint", _motor),
    "paused": ("paused by its own button", _set(paused=True)),
    "mislocalised": ("does not know its place", _set(localised=False)),
    "slow-cancel": ("drives on to the next node before it cancels", _set(slow=True)),
    "battery": ("battery at 9 %", _set(battery=9.0)),
}
