namespace Msisf.Core.Surface.Sources;

/// <summary>Which of two models gives way where a finer one meets a coarser one (docs/elevation-seams.md).</summary>
public enum NestBlend
{
    /// <summary>
    /// The coarser one: the finer model keeps its samples to the last, and the difference at its border is carried into the coarser one.
    /// </summary>
    Outward,

    /// <summary>The finer one: along its border it is bent to meet the facets of the coarser one.</summary>
    Inward,
}
