ARG BASE_IMAGE=python:3.11-slim

FROM ${BASE_IMAGE} AS packages
ARG REQUIREMENTS=run
COPY requirements/${REQUIREMENTS}.txt requirements.txt
RUN python -m venv /packages \
    && /packages/bin/pip install --no-cache-dir --require-hashes --no-deps -r requirements.txt \
    && /packages/bin/python -m compileall -q /packages/lib \
    && /packages/bin/pip uninstall --yes --quiet pip setuptools

FROM ${BASE_IMAGE}
ARG BUILD=
ENV PATH=/packages/bin:$PATH PYTHONDONTWRITEBYTECODE=1 KHV_HOST=0.0.0.0 KHV_BUILD=${BUILD}
WORKDIR /service
COPY --from=packages /packages /packages
COPY core core
COPY app app
COPY static static
COPY LICENSE LICENSE
RUN python -m compileall -q core app && python -m app.compiled

USER 65534:65534
EXPOSE 8000
HEALTHCHECK --interval=30s --timeout=3s --start-period=10s \
    CMD ["python", "-c", "import urllib.request; urllib.request.urlopen('http://127.0.0.1:8000/livez', timeout=2)"]
CMD ["python", "-m", "app.serve"]
