using Msisf.Core.Surface;

namespace Msisf.Core.Navigation;

/// <summary>A landmark whose place lies inside an image.</summary>
/// <param name="PointBodyFixed">m.</param>
/// <param name="X">Rendering coordinate.</param>
/// <param name="Y">Rendering coordinate.</param>
public sealed record LandmarkView(Landmark Landmark, Vector3D PointBodyFixed, double X, double Y)
{
    /// <summary>The facet that hides it from the camera; null if it is visible.</summary>
    public FacetId? HiddenBy { get; init; }

    /// <summary>Whether the centre of the Sun, or the lamp, shines on it.</summary>
    public required bool IsLit { get; init; }

    /// <summary>rad: from the normal of the ground below or above it to the light; null outside a map of a part of the Moon.</summary>
    public double? Incidence { get; init; }

    /// <summary>m: from the camera.</summary>
    public required double Range { get; init; }

    /// <summary>m: side of the square that has the area of the pixel's beam there, across the line of sight.</summary>
    public required double PixelScale { get; init; }

    /// <summary>How the pixel moves with the camera and with the point.</summary>
    public required PixelDerivatives Derivatives { get; init; }
}

/// <summary>The landmarks of a frame.</summary>
/// <param name="Views">Those whose place lies inside the image, hidden ones too, in the order of the list.</param>
/// <param name="Outside">How many more there are.</param>
public sealed record LandmarksOfFrame(IReadOnlyList<LandmarkView> Views, int Outside);

/// <summary>A point of a list of landmarks. Immutable.</summary>
/// <param name="Number">The list's row, from 1, without its heading.</param>
/// <param name="Identity">The list's own name of the row, its number where there is none; no two are the same.</param>
/// <param name="Name">Null where the list has none.</param>
/// <param name="Direction">From the Moon's centre, length 1, body-fixed.</param>
/// <param name="Height">m over the reference radius; null for a point on the terrain.</param>
public sealed record Landmark(int Number, string Identity, string? Name, Vector3D Direction, double? Height);

/// <summary>What a frame says for navigation, beside its pixels.</summary>
public sealed record NavigationTruth
{
    /// <summary>The craters of the catalogue; null without one.</summary>
    public CratersOfFrame? Craters { get; init; }

    /// <summary>The landmarks of the list; null without one.</summary>
    public LandmarksOfFrame? Landmarks { get; init; }
}
