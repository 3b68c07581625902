namespace Msisf.Adapters.Tiles;

/// <summary>How a pattern file writes its mesh (docs/pattern-format.md).</summary>
public enum PatternFormat
{
    /// <summary>POV-Ray's mesh2 with whole lattice steps: exact, the default.</summary>
    Mesh2,

    /// <summary>
    /// POV-Ray's mesh with one triangle after the other in kilometres, as in the thesis: larger, and rounded to 0.1 m by POV-Ray.
    /// </summary>
    Mesh,
}
