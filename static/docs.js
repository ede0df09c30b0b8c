/* The API's description, without anything from another host. */
SwaggerUIBundle({
  url: "api/v1/openapi.json",
  dom_id: "#api",
  validatorUrl: null,
  deepLinking: true,
  defaultModelsExpandDepth: 0,
});
