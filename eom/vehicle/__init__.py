"""The description of a vehicle: text, schema, expressions, units of measure, the train of units."""
