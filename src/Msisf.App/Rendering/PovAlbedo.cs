using Msisf.Adapters.IO;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Adapters.Scene;
using Msisf.Core.Camera;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.App.Rendering;

/// <summary>The images of a map's levels that POV-Ray's scenes need, each made once. Thread-safe.</summary>
/// <param name="folder">The folder of the patterns, where POV-Ray looks for included files.</param>
internal sealed class PovAlbedo(OpenedAlbedoMap opened, string folder)
{
    private readonly Lock _gate = new();

    /// <summary>The map for a frame: the finest level with pixels at least as large as the image's where the Moon is nearest.</summary>
    public SceneAlbedo For(FrameCamera camera)
    {
        AlbedoMap map = opened.Map;
        double distance = Math.Max(camera.PositionBodyFixed.Length - MoonConstants.ReferenceRadius, 1.0);
        double mapPixel = MoonConstants.ReferenceRadius * map.Extent.Height / map.Levels[0].Height;
        double ratio = camera.PixelTangent * distance / mapPixel;
        int level = ratio > 1.0 ? Math.Min(Math.ILogB(ratio), map.Levels.Count - 1) : 0;
        string meaning = Invariant($"{opened.Sha256[..16]}-{map.Offset:R}-{map.Step:R}-{level}").Replace('+', 'p');
        string name = $"albedo-poles-{meaning}.png";
        string path = Path.Combine(folder, name);
        lock (_gate)
        {
            if (!File.Exists(path))
            {
                FileErrors.ToExternalPart($"{folder}: the folder can't be made", () => Directory.CreateDirectory(folder));
                AtomicFile.Write(path, stream => PovAlbedoImage.Write(stream, opened.Name, map, level));
            }
        }

        return new SceneAlbedo(
            name, double.RadiansToDegrees(map.Extent.West), map.Levels[level].Height, PovAlbedoImage.DiffuseOf(map));
    }
}
