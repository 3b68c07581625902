using Msisf.Adapters.Tiles;
using Msisf.App.Preparation;
using Msisf.App.Settings;

namespace Msisf.App.Rendering;

/// <summary>Makes the surface of a run for POV-Ray.</summary>
internal static class SceneSurfaces
{
    /// <summary>The surface of a run's model.</summary>
    public static ISceneSurface Of(ElevationModel model, RenderSettings settings)
    {
        PatternRepository repository = new(settings.PatternRepository);
        return model.IsWholeMoon
            ? new TileSurface(model, settings.LevelOfDetailError, repository)
            : new BlockSurface(model.Grid, model.DetailOf(settings.LevelOfDetailError), settings.DetailSubsamplesPerAxis, repository);
    }
}
