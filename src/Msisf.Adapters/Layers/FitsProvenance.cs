using System.Text;
using Msisf.Adapters.Interop;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Layers;

/// <summary>The keywords of the primary unit: all that the image depends on, and no creation date (same input, same bytes).</summary>
internal static class FitsProvenance
{
    private static readonly string[] Remarks =
    [
        "Ground truth of each pixel of a synthetic image of the Moon, one layer an extension. "
            + "Positions and directions are in MOON_ME (mean Earth/polar axis), from the Moon's centre, in m.",
        "Pixel (x, y) of the image, from 1, x right and y DOWN, is FITS pixel (x, y): "
            + "the first row of the data is the image's top row, in numpy data[y - 1, x - 1]. "
            + "Programs that draw the first row at the bottom show the image upside down.",
        "Pixels that show no surface are NaN in layers of real numbers (FITS standard 4.0, section 5.3), "
            + "BLANK in layers of whole numbers, and 0 in MASK; "
            + "RADIANCE_FACTOR and RADIANCE are means over samples and have values there too.",
    ];

    public static void Put(FitsUnit unit, FrameMetadata frame, LayerProvenance provenance)
    {
        UnitQuaternion orientation = frame.Camera.MoonFromCamera;
        unit.DeclareLongTexts();
        unit.Put("CREATOR", FitsText.Ascii($"MSISF {frame.Version}"), "program and version");
        unit.Put("CMDLINE", FitsText.Ascii(frame.CommandLine), "arguments of the call");
        unit.Put("RENDERER", FitsText.Ascii(provenance.Renderer), "what found the surface of each pixel");
        unit.Put("TIMESYS", "UTC", "time system");
        unit.Put("DATE-OBS", frame.SimulationTime.ToIsoUtc().TrimEnd('Z'), "simulation time");
        unit.Put("MJD-OBS", frame.SimulationTime.Mjd, "[d] simulation time");
        unit.Put("OBJECT", frame.Globe.Body.Name, string.Empty);
        unit.Put("REFFRAME", frame.Globe.Body.Frame, "of positions, directions, orientation");
        PutVector(unit, "CAMPOS", frame.Camera.PositionBodyFixed, "camera", frame.Globe);
        unit.Put("CAMQX", orientation.X, frame.Globe.Describe("camera axes to MOON_ME: looks along -x,"));
        unit.Put("CAMQY", orientation.Y, "y right, z up");
        unit.Put("CAMQZ", orientation.Z, string.Empty);
        unit.Put("CAMQ0", orientation.W, "real part");
        unit.Put("CAMFOV", frame.FieldOfViewDegrees, "[deg] horizontal field of view");
        unit.Put("CAMALT", frame.FlightAltitude, "[m] camera over the mean radius");
        unit.Put("CAMTERR", frame.HeightOverTerrain, "[m] camera over the elevation model below");
        PutMatrix(unit, CameraMatrix.Of(frame.Camera), frame.Globe);
        PutVector(unit, "SUNPOS", frame.SunPositionBodyFixed, "Sun, or lamp", frame.Globe);
        unit.Put("MEANRAD", frame.Globe.AltitudeRadius, "[m] mean radius, for CAMALT");
        unit.Put("REFRAD", frame.Globe.ReferenceRadius, "[m] reference radius, for HEIGHT");
        unit.Put("ELEVMODL", FitsText.Ascii(provenance.ElevationProduct), "elevation model");
        if (provenance.InventedDetail is { } detail)
        {
            unit.Put("INVENTED", FitsText.Ascii(detail), "detail below the model, not on the real Moon");
        }

        PutResolution(unit, "ELEVRES", frame.Elevation.Resolution, "of the elevation model");
        unit.Put("LOD", provenance.LevelOfDetail, "level of detail, 0 is the model itself");
        PutResolution(unit, "MESHRES", provenance.MeshResolution, "of the mesh that CELL counts in");
        PutInputs(unit, frame.Inputs);
        foreach (string line in Remarks.Select(frame.Globe.Describe).SelectMany(FitsText.Wrap))
        {
            unit.PutComment(line);
        }
    }

    /// <summary>Names the files that the data were made from, with their kinds and checksums.</summary>
    public static void PutInputs(FitsUnit unit, IReadOnlyList<InputFile> inputs)
    {
        for (int i = 0; i < inputs.Count; i++)
        {
            unit.Put(
                Invariant($"INPUT{i + 1}"), FitsText.Ascii($"{OriginXml.WordOf(inputs[i].Kind)} {inputs[i].Text}"),
                string.Empty);
        }
    }

    private static void PutResolution(FitsUnit unit, string key, GridResolution resolution, string whose)
    {
        if (resolution.PixelsPerDegree is { } pixelsPerDegree)
        {
            unit.Put(key, pixelsPerDegree, $"[px/deg] {whose}");
        }
        else
        {
            unit.Put(key, resolution.MetresPerPixel, $"[m/px] {whose}");
        }
    }

    /// <summary>OpenCV's form of the camera: K, R and t by rows and columns from 1, as the standard's CDi_j.</summary>
    private static void PutMatrix(FitsUnit unit, CameraMatrix camera, DrawnGlobe globe)
    {
        unit.Put("CAMW", camera.Width, "[px] image width");
        unit.Put("CAMH", camera.Height, "[px] image height");
        PutRows(unit, "CAMK", camera.IntrinsicRows, "[px] K: p = K (R X + t), pixels from 0");
        PutRows(unit, "CAMR", camera.RotationRows, globe.Describe("R: MOON_ME to x right, y down, z ahead"));
        unit.Put("CAMT1", camera.Translation.X, "[m] t = -R times the camera's position");
        unit.Put("CAMT2", camera.Translation.Y, "[m]");
        unit.Put("CAMT3", camera.Translation.Z, "[m]");
        if (camera.Distortion is not { } distortion)
        {
            return;
        }

        unit.Put("CAMDIST", distortion.Name, "distortion, before K; docs/cameras.md");
        for (int i = 0; i < distortion.Coefficients.Count; i++)
        {
            unit.Put(Invariant($"CAMD{i + 1}"), distortion.Coefficients[i], string.Empty);
        }
    }

    private static void PutRows(FitsUnit unit, string key, IReadOnlyList<Vector3D> rows, string what)
    {
        for (int row = 0; row < rows.Count; row++)
        {
            unit.Put(Invariant($"{key}{row + 1}_1"), rows[row].X, what);
            unit.Put(Invariant($"{key}{row + 1}_2"), rows[row].Y, string.Empty);
            unit.Put(Invariant($"{key}{row + 1}_3"), rows[row].Z, string.Empty);
        }
    }

    private static void PutVector(FitsUnit unit, string key, Vector3D vector, string what, DrawnGlobe globe)
    {
        unit.Put($"{key}X", vector.X, globe.Describe($"[m] {what}, MOON_ME x"));
        unit.Put($"{key}Y", vector.Y, globe.Describe($"[m] {what}, MOON_ME y"));
        unit.Put($"{key}Z", vector.Z, globe.Describe($"[m] {what}, MOON_ME z"));
    }
}

/// <summary>Texts for FITS headers, which hold printable ASCII only.</summary>
internal static class FitsText
{
    /// <summary>Characters of a COMMENT card.</summary>
    private const int CardText = 72;

    /// <summary>
    /// Escapes characters that are not printable ASCII as JSON does (\u00e4), each UTF-16 unit for itself, and the backslash, so that
    /// nothing is lost. The apostrophe is escaped too: FITS could hold it, but astropy before 5.3 ends a long text at one.
    /// </summary>
    public static string Ascii(string text)
    {
        StringBuilder ascii = new(text.Length);
        foreach (char character in text)
        {
            if (character is >= ' ' and <= '~' and not '\'' and not '\\')
            {
                ascii.Append(character);
            }
            else
            {
                ascii.Append(CultureInfo.InvariantCulture, $"\\u{(int)character:x4}");
            }
        }

        return ascii.ToString();
    }

    /// <summary>Breaks a text of short words into lines for COMMENT cards.</summary>
    public static IEnumerable<string> Wrap(string text)
    {
        StringBuilder line = new();
        foreach (string word in text.Split(' '))
        {
            if (line.Length > 0 && line.Length + 1 + word.Length > CardText)
            {
                yield return line.ToString();
                line.Clear();
            }

            line.Append(line.Length > 0 ? " " : string.Empty).Append(word);
        }

        yield return line.ToString();
    }
}
