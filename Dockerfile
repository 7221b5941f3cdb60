# The service of foon-kg (page, API, explorer) as an image; docker-compose.yml runs it beside a Neo4j:
#
#   NEO4J_PASSWORD=... docker compose --profile service up --build --wait
#
# The versions of all packages are those that the tests run with.
FROM python:3.11-slim AS build
WORKDIR /source
COPY . .
RUN sed -n 's/^\([A-Za-z0-9_.-]*==[^\\]*\).*/\1/p' requirements-dev.txt > /constraints.txt \
    && pip wheel --no-cache-dir --no-deps --wheel-dir /wheels .

FROM python:3.11-slim
COPY --from=build /constraints.txt /wheels/ /install/
RUN pip install --no-cache-dir --constraint /install/constraints.txt "$(ls /install/*.whl)[agents,fast,pictures,web]" \
    && rm -r /install \
    && useradd --create-home foon
USER foon
WORKDIR /home/foon
EXPOSE 8000
HEALTHCHECK --interval=10s --timeout=5s --start-period=60s \
    CMD ["python", "-c", "import urllib.request as web; web.urlopen('http://127.0.0.1:8000/health', timeout=4)"]
ENTRYPOINT ["foon"]
CMD ["serve", "--host", "0.0.0.0", "--token-file", "/home/foon/token"]
