using Msisf.Adapters.Terrain;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Run;

/// <summary>The elevation model of a run, with what is derived from it once. Safe for several threads.</summary>
internal sealed class ElevationModel : IDisposable
{
    private readonly LdemImage _image;

    private ElevationModel(LdemImage image)
    {
        _image = image;
    }

    public IElevationGrid Grid => _image;

    /// <summary>Finds and opens the model of a resolution.</summary>
    /// <param name="explicitPath">The user's <c>--ldem</c>, or null to look in ./input/ldem and in the installation.</param>
    /// <param name="pixelsPerDegree">The resolution.</param>
    /// <param name="host">Where the installation is, and where notes go.</param>
    public static ElevationModel Open(string? explicitPath, int pixelsPerDegree, ProgramHost host)
    {
        string[] folders = [.. ((string[])[Path.Combine("input", "ldem"), host.Installation.ElevationModels]).DistinctBy(Path.GetFullPath)];
        LdemImage image = LdemImage.Open(LdemCatalog.Find(pixelsPerDegree, explicitPath, folders));
        host.Log.Note(image.Label.IsSynthetic
            ? $"Elevation: {image.ProductId}, a SYNTHETIC model, not the real Moon ({image.Label.LabelPath})."
            : $"Elevation: {image.ProductId} ({image.Label.LabelPath}).");
        return new ElevationModel(image);
    }

#pragma warning disable CA1822
    public TileSelection Select(Frame frame) =>
        new TileSelection([.. TileId.All.Select(t => new TileChoice(t, TileReason.Visible))]);

    /// <summary>How far a position lies below the terrain, m; 0 or less if it is above.</summary>
    public double DepthBelowGround(Vector3D positionMoonMe) => MoonConstants.ReferenceRadius - positionMoonMe.Length;

    public void Dispose() => _image.Dispose();
}
