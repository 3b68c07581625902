using Msisf.Adapters.Raster.Albedo;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Illumination;

/// <summary>
/// A polar map of light of E. Mazarico et al., Icarus 211 (2011) 1066, as LOLA's archive has it: LPSR_*, 1 where a place is permanently
/// shadowed, or AVGVISIB_*, the mean visible part of the Sun's disc. Immutable.
/// </summary>
public sealed class NasaLightMap
{
    private readonly PolarStereographic _projection;
    private readonly int _lines;
    private readonly int _samples;
    private readonly float[] _values;

    private NasaLightMap(string product, PolarStereographic projection, PdsMapLabel label, float[] values)
    {
        (Product, _projection, _values) = (product, projection, values);
        (_lines, _samples) = (label.Lines, label.LineSamples);
    }

    /// <summary>PRODUCT_ID of the label.</summary>
    public string Product { get; }

    /// <summary>Whether it tells where it is permanently shadowed; if not, the mean visible part of the Sun.</summary>
    public bool IsOfShadow => Product.StartsWith(ShadowName, StringComparison.OrdinalIgnoreCase);

    private const string ShadowName = "LPSR_";

    private const string LightName = "AVGVISIB_";

    /// <summary>Reads a map.</summary>
    /// <param name="path">Its label, or its image.</param>
    /// <exception cref="BadInputException">It is none of these maps.</exception>
    public static NasaLightMap Read(string path)
    {
        string wanted = $"a map {ShadowName}*.LBL or {LightName}*.LBL of LOLA's archive, with its .IMG, is needed";
        PdsMapHead head = PdsMapHead.TryRead(path) ?? throw new BadInputException($"{path}: no PDS3 label; {wanted}.");
        bool isEarth = head.Product.Contains("EARTH", StringComparison.OrdinalIgnoreCase);
        if (isEarth || !((string[])[ShadowName, LightName]).Any(
            name => head.Product.StartsWith(name, StringComparison.OrdinalIgnoreCase)))
        {
            throw new BadInputException($"{head.LabelPath}: PRODUCT_ID = {head.Product}; {wanted}.");
        }

        PdsMapLabel label = PdsMapLabel.ReadPolar(head);
        PolarStereographic projection = PolarLabel.ProjectionOf(head.Label.FindObject("IMAGE_MAP_PROJECTION")!);
        float[] values = new float[checked(label.Lines * label.LineSamples)];
        using (PdsMapSource source = new(label))
        {
            source.Read(0, label.Lines, values);
        }

        for (int i = 0; i < values.Length; i++)
        {
            values[i] = (float)((values[i] * label.ScalingFactor) + label.Offset);
            if (values[i] is < -0.001f or > 1.001f)
            {
                throw new BadInputException(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{label.ImagePath}, line {i / label.LineSamples}, sample {i % label.LineSamples}: {values[i]:R} by the label's "
                        + $"SCALING_FACTOR and OFFSET; 0 to 1 is needed."));
            }
        }

        return new NasaLightMap(head.Product, projection, label, values);
    }

    /// <summary>The value of the pixel that a direction lies in; null beside the map and where it has no data.</summary>
    /// <param name="directionBodyFixed">MOON_ME.</param>
    public float? At(Vector3D directionBodyFixed)
    {
        if (directionBodyFixed.Z * _projection.PoleSign <= 0.0)
        {
            return null;
        }

        (double line, double sample) = _projection.PixelOf(directionBodyFixed);
        (double nearestLine, double nearestSample) = (Math.Round(line), Math.Round(sample));
        return nearestLine >= 0.0 && nearestLine < _lines && nearestSample >= 0.0 && nearestSample < _samples
            && _values[((int)nearestLine * _samples) + (int)nearestSample] is var value && !float.IsNaN(value)
                ? value
                : null;
    }
}
