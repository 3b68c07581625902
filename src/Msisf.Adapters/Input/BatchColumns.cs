using Msisf.Core.Camera;

namespace Msisf.Adapters.Input;

/// <summary>The named columns of a batch file.</summary>
internal sealed class BatchColumns
{
    private readonly Dictionary<string, (int Index, string Written)> _columns = [];
    private readonly List<string> _ignored = [];

    /// <summary>Reads the header.</summary>
    /// <param name="header">The line of names, separated by commas.</param>
    /// <param name="ignoresUnknown">Whether columns that are not known are left out.</param>
    /// <exception cref="BadInputException">A name is not known, or a column occurs twice.</exception>
    public BatchColumns(string header, bool ignoresUnknown)
    {
        string[] names = Fields(header);
        Count = names.Length;
        for (int index = 0; index < names.Length; index++)
        {
            string written = names[index];
            if (BatchNames.Known(written) is not { } name)
            {
                _ignored.Add(ignoresUnknown ? $"'{written}'" : throw new BadInputException(Unknown(index + 1, written)));
            }
            else if (!_columns.TryAdd(name, (index, written)))
            {
                string first = _columns[name].Written;
                string also = first.Equals(written, StringComparison.OrdinalIgnoreCase) ? string.Empty : $", as {first} too";
                throw new BadInputException($"column {index + 1}: '{written}' occurs twice{also}. Remove one of them.");
            }
        }
    }

    /// <summary>Number of values in a line.</summary>
    public int Count { get; }

    /// <summary>Names of the columns that are left out, in quotes.</summary>
    public IReadOnlyList<string> Ignored => _ignored;

    /// <summary>Whether the first line of a file names columns; otherwise it is a state of eight numbers.</summary>
    public static bool IsHeader(ReadOnlySpan<char> line) =>
        line.ContainsAny(',', ';') && !TimeText.TryParse(line[..line.IndexOfAny(',', ';')].Trim(), out _);

    /// <summary>The fields of a line, without the quotes that spreadsheets put around them.</summary>
    public static string[] Fields(string line) =>
        [.. line.Split(',', StringSplitOptions.TrimEntries).Select(field => field is ['"', .. string inner, '"'] ? inner.Trim() : field)];

    /// <summary>Whether there is a column.</summary>
    /// <param name="name">Its name of <see cref="BatchNames"/>.</param>
    public bool Has(string name) => _columns.ContainsKey(name);

    /// <summary>Where a column is, from 0, and its name as the file writes it.</summary>
    /// <param name="name">Its name of <see cref="BatchNames"/>; there must be such a column.</param>
    public (int Index, string Written) Of(string name) => _columns[name];

    private static string Unknown(int number, string written)
    {
        if (written.Length == 0)
        {
            return $"column {number} has no name. Name or remove it, or give --ignore-columns.";
        }

        if (written.Contains(';'))
        {
            return "columns and values are apart by commas, not by semicolons. Save the file with commas.";
        }

        if (written.Equals("q4", StringComparison.OrdinalIgnoreCase))
        {
            return $"column {number}: of q1 to q4 some programs mean q4 as the scalar, others q1. Name the columns qx, qy, qz, qw.";
        }

        return $"column {number}: {NumberText.Shown(written)} is not a column{NearestName.Question(written, BatchNames.All, ".")} "
            + $"There are {string.Join(", ", BatchNames.All)}. --ignore-columns leaves others out.";
    }
}

/// <summary>Names of the columns of a batch file, in the groups that go together.</summary>
internal static class BatchNames
{
    public const string Time = "time";
    public const string Seconds = "seconds";
    public const string Height = "height";
    public const string HeightKilometres = "height_km";
    public const string Altitude = "alt";
    public const string NamedPlace = "place";
    public const string LookAt = "look_at";
    public const string LookHeight = "look_height";
    public const string OffNadir = "off_nadir";
    public const string Azimuth = "azimuth";
    public const string Roll = "roll";
    public const string Up = "up";
    public const string Noise = "noise_seed";
    public const string Exposure = "exposure_factor";

    private static readonly Dictionary<string, string> OtherNames = new(StringComparer.OrdinalIgnoreCase)
    {
        ["MJD"] = Time,
        ["rx"] = "x",
        ["ry"] = "y",
        ["rz"] = "z",
        ["q0"] = "qw",
        ["q1"] = "qx",
        ["q2"] = "qy",
        ["q3"] = "qz",
    };

    /// <summary>Latitude and longitude of the camera; one of <see cref="Heights"/> goes with them.</summary>
    public static string[] Place { get; } = ["lat", "lon"];

    /// <summary>Ways to give the camera's height.</summary>
    public static string[] Heights { get; } = [Height, HeightKilometres, Altitude];

    public static string[] Position { get; } = ["x", "y", "z"];

    public static string[] PositionKilometres { get; } = ["x_km", "y_km", "z_km"];

    public static string[] Quaternion { get; } = ["qx", "qy", "qz", "qw"];

    public static string[] Matrix { get; } = ["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"];

    public static string[] Euler { get; } = ["euler1", "euler2", "euler3"];

    public static string[] Target { get; } = ["look_lat", "look_lon"];

    public static string[] Motion { get; } = [.. CameraMotion.NumberNames];

    public static string[] Sun { get; } = ["sun_x", "sun_y", "sun_z"];

    /// <summary>All names, in the order in which messages list them.</summary>
    public static string[] All { get; } =
    [
        Time, Seconds, .. Place, NamedPlace, .. Heights, .. Position, .. PositionKilometres, .. Quaternion, .. Matrix, .. Euler, .. Target,
        LookAt, LookHeight, OffNadir, Azimuth, Roll, Up, .. Motion, .. Sun, Noise, Exposure,
    ];

    /// <summary>The name of a column, whatever its case, or whichever of its names is written; null if there is no such column.</summary>
    public static string? Known(string written)
    {
        string name = OtherNames.GetValueOrDefault(written, written);
        return Array.Find(All, known => known.Equals(name, StringComparison.OrdinalIgnoreCase));
    }
}
