using System.Text.Json.Serialization;

namespace Msisf.App.Serving;

/// <summary>A facet of the surface (docs/pattern-format.md).</summary>
/// <param name="Line">Line of its cell, 0 for the northernmost; -1 is the fan around the north pole.</param>
/// <param name="Sample">Sample of its cell, from 0.</param>
/// <param name="Half">Which of the two facets of the cell.</param>
/// <param name="Part">
/// The model, from 0 for the coarsest of several; their number stands for the seams between them. 0 of one.
/// </param>
/// <param name="Invented">Whether it is of invented detail; null, and left out, of frames without.</param>
internal sealed record FacetReading(
    int Line, int Sample, int Half, int Part,
    [property: JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)] bool? Invented = null);
