using System.Text.RegularExpressions;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// An image of LOLA's models of the whole Moon whose label is not there: name and length say all that the label would.
/// </summary>
internal static partial class BareImage
{
    /// <summary>The label that an image would have.</summary>
    /// <param name="path">The image.</param>
    /// <returns>Null if there is a label, or name and length are not those of such an image.</returns>
    public static LdemLabel? LabelOf(string path)
    {
        Match name = Name().Match(Path.GetFileName(path));
        if (!name.Success || !File.Exists(path) || FileNames.LabelOf(path) != path
            || !int.TryParse(name.Groups["res"].ValueSpan, NumberStyles.None, CultureInfo.InvariantCulture, out int resolution)
            || resolution > MostResolution)
        {
            return null;
        }

        bool hasFloats = name.Groups["float"].Success;
        double step = hasFloats ? 1000.0 : 0.5;
        LdemLabel label = new(
            path, path, ImageOffset: 0, Path.GetFileNameWithoutExtension(path).ToUpperInvariant(), CelestialBody.Moon, resolution,
            180 * resolution, 360 * resolution, hasFloats ? LdemSampleType.Float32LittleEndian : LdemSampleType.Int16LittleEndian, step,
            MoonConstants.ReferenceRadius, MoonConstants.PlausibleHeights.Min / step, MoonConstants.PlausibleHeights.Max / step,
            NorthDegrees: 90.0, SouthDegrees: -90.0, WestDegrees: 0.0, EastDegrees: 360.0,
            CoordinateSystem: "MEAN EARTH/POLAR AXIS OF DE421");
        return new FileInfo(path).Length == label.ImageBytes ? label : null;
    }

    /// <summary>px/deg: the finest model that LOLA has in one file has 128; files of more are longer than any disk.</summary>
    private const int MostResolution = 1024;

    [GeneratedRegex("^LDEM_(?<res>[0-9]{1,4})(?<float>_FLOAT)?\\.IMG$", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex Name();
}
