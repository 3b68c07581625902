using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Surface;

namespace Msisf.Core.Sky;

/// <summary>A star whose place lies inside an image.</summary>
/// <param name="X">Rendering coordinate, in the middle of the exposure.</param>
/// <param name="Y">Rendering coordinate.</param>
/// <param name="ApparentJ2000">In which direction the camera sees it, length 1, J2000.</param>
/// <param name="HiddenBy">The facet that hides it in the middle of the exposure; null if it is visible.</param>
public sealed record StarView(Star Star, double X, double Y, Vector3D ApparentJ2000, FacetId? HiddenBy)
{
    /// <summary>The body of the sky behind which it is; null for none that is drawn.</summary>
    public SkyBody? Behind { get; init; }

    /// <summary>Whether neither ground nor a body of the sky hides it in the middle of the exposure.</summary>
    public bool IsVisible => HiddenBy is null && Behind is null;

    /// <summary>Electrons that it frees in the image; null without a detector.</summary>
    public double? Electrons { get; init; }

    /// <summary>Where it is at the begin and at the end of the exposure, of what the image shows of that; null without motion.</summary>
    public (RenderingPoint Start, RenderingPoint End)? Streak { get; init; }

    /// <summary>px/rad: how the place moves with turns of the camera about its own axes (-x forward, y right, z up).</summary>
    public required (Vector3D X, Vector3D Y) ByTurn { get; init; }
}

/// <summary>The stars of an image.</summary>
/// <param name="Views">Those whose place lies inside the image, hidden ones too, in the order of the catalogue.</param>
public sealed record StarsOfFrame(IReadOnlyList<StarView> Views);
