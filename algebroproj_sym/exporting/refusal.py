"""Why a claim cannot be exported."""


class NotExportable(ValueError):  # noqa: N818 - a finding, not a malfunction
    """A claim has no theorem, for a reason."""


class Silent(NotExportable):
    """A claim states nothing that a theorem could say."""


class AnotherForm(NotExportable):
    """The recorded steps of a derivation do not make the form of the ledger."""
