using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.Core.Navigation;
using Msisf.Core.Render;

namespace Msisf.App.Rendering;

/// <summary>Finds the truth for navigation of frames. Thread-safe.</summary>
/// <param name="inputs">What it is made from.</param>
internal sealed class FrameNavigation(NavigationInputs inputs)
{
    public NavigationTruth Of(RenderedFrame rendered)
    {
        ArgumentNullException.ThrowIfNull(rendered.Truth);
        ArgumentNullException.ThrowIfNull(rendered.Terrain);
        IGroundTruth frame = rendered.Truth;
        return new NavigationTruth
        {
            Craters = inputs.Craters is { } finder
                ? CraterPixels.WithParts(finder.Find(frame.Camera, frame.Light, rendered.Terrain), frame)
                : null,
            Landmarks = inputs.Landmarks?.Find(frame.Camera, frame.Light, rendered.Terrain),
        };
    }
}
