"""The packages that only the local server needs: the optional extra ``server``."""

from foon_kg.model.errors import ServerError


def missing_extra(package: str | None) -> ServerError:
    """Return the error for a package of the extra that is not installed."""
    return ServerError(
        f"the local Neo4j needs the Python package {package}, which is not installed",
        hint="pip install 'foon-kg[server]', or name a Neo4j of your own with NEO4J_URI",
        code="missing-package",
    )
