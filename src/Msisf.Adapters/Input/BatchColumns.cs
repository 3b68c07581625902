using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Adapters.Input;

/// <summary>The named columns of a batch file, and how a line of it becomes a state.</summary>
internal sealed class BatchColumns
{
    private const string Time = "time";
    private const string LookHeight = "look_height";
    private const string OffNadir = "off_nadir";
    private const string Azimuth = "azimuth";
    private const string Roll = "roll";
    private const string Up = "up";

    private static readonly string[] Place = ["lat", "lon", "height"];
    private static readonly string[] Position = ["x", "y", "z"];
    private static readonly string[] Quaternion = ["qx", "qy", "qz", "qw"];
    private static readonly string[] Motion = [.. CameraMotion.NumberNames];
    private static readonly string[] Target = ["look_lat", "look_lon"];
    private static readonly string[] Known =
        [Time, .. Place, .. Position, .. Quaternion, .. Target, LookHeight, OffNadir, Azimuth, Roll, Up, .. Motion];

    private static readonly Dictionary<string, string> NamesOfThesis = new(StringComparer.OrdinalIgnoreCase)
    {
        ["MJD"] = Time,
        ["rx"] = "x",
        ["ry"] = "y",
        ["rz"] = "z",
        ["q0"] = "qw",
    };

    private readonly Dictionary<string, int> _columns = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<int> _hiddenTargets = [];
    private readonly string _fileName;

    /// <summary>Reads the header.</summary>
    /// <param name="header">The line of names, separated by commas.</param>
    /// <param name="fileName">For messages.</param>
    /// <param name="lineNumber">Number of the line, from 1.</param>
    /// <exception cref="BadInputException">A name is not known, stands twice, or the names do not make a state.</exception>
    public BatchColumns(string header, string fileName, int lineNumber)
    {
        _fileName = fileName;
        string[] names = Fields(header);
        for (int index = 0; index < names.Length; index++)
        {
            string name = NamesOfThesis.GetValueOrDefault(names[index], names[index]);
            if (!Known.Contains(name, StringComparer.OrdinalIgnoreCase))
            {
                throw Wrong(lineNumber, name.Length == 0
                    ? $"column {index + 1} has no name. Name or remove it."
                    : name.Contains(';') ? "columns and values are apart by commas, not by semicolons. Save the file with commas."
                    : $"column {index + 1}: {NumberText.Shown(name)} is no column"
                        + $"{(NearestName.Question(name, Known) is { Length: > 0 } question ? question : ".")} "
                        + $"There are {string.Join(", ", Known)}.");
            }

            if (!_columns.TryAdd(name, index))
            {
                throw Wrong(lineNumber, $"column {index + 1}: '{name}' stands twice. Remove one of them.");
            }
        }

        CheckColumns(lineNumber);
    }

    /// <summary>Numbers of the lines, read so far, whose camera looks at a place that the Moon hides.</summary>
    public IReadOnlyList<int> HiddenTargets => _hiddenTargets;

    /// <summary>Whether a word is the name of a column.</summary>
    public static bool IsName(ReadOnlySpan<char> word) =>
        Known.Contains(word.ToString(), StringComparer.OrdinalIgnoreCase) || NamesOfThesis.ContainsKey(word.ToString());

    /// <summary>Whether the first line of a file names columns; else it is a state of eight numbers.</summary>
    public static bool IsHeader(ReadOnlySpan<char> line) =>
        line.ContainsAny(',', ';') && !TimeText.TryParse(line[..line.IndexOfAny(',', ';')].Trim(), out _);

    /// <summary>Reads a line.</summary>
    /// <param name="line">The values, separated by commas.</param>
    /// <param name="lineNumber">Number of the line, from 1.</param>
    /// <param name="scene">Terrain and Sun, for what refers to them.</param>
    /// <exception cref="BadInputException">A value is wrong; the message names line and column.</exception>
    public SpacecraftState ReadState(ReadOnlySpan<char> line, int lineNumber, ISceneGeometry scene)
    {
        string[] values = Fields(line.ToString());
        if (values.Length != _columns.Count)
        {
            throw Wrong(lineNumber, $"{values.Length} values, {_columns.Count} columns. Complete, shorten or remove the line.");
        }

        ModifiedJulianDate time = Read(Time, text => TimeText.Parse(text));
        Vector3D position = Has(Place[0])
            ? Checked(() => ReadPlace(Place[0], Place[1], Place[2]).ToPositionMoonMe(scene.GroundRadius, scene.ReferenceRadius))
            : new Vector3D(Number(Position[0]), Number(Position[1]), Number(Position[2]));
        UnitQuaternion attitude = Checked(() => Has(Quaternion[0])
            ? UnitQuaternion.FromComponents(Number(Quaternion[0]), Number(Quaternion[1]), Number(Quaternion[2]), Number(Quaternion[3]))
            : Pointed(Pointing()));
        return new SpacecraftState(time, position, attitude)
        {
            Motion = Has(Motion[0]) ? Checked(() => CameraMotion.FromNumbers([.. Motion.Select(Number)])) : null,
        };

        UnitQuaternion Pointed(CameraPointing pointing)
        {
            UnitQuaternion pointed = pointing.MoonFromCamera(position, time, scene);
            if (pointing.IsTargetHidden(position, scene))
            {
                _hiddenTargets.Add(lineNumber);
            }

            return pointed;
        }

        CameraPointing Pointing() => Direction() with
        {
            Roll = Has(Roll) ? double.DegreesToRadians(Number(Roll)) : 0.0,
            Up = Has(Up) ? Read(Up, PointingText.ParseUp) : UpDirection.Zenith,
        };

        CameraPointing Direction() => Has(Target[0])
            ? new CameraPointing { Kind = BoresightKind.Place, Target = ReadPlace(Target[0], Target[1], LookHeight) }
            : Has(OffNadir) ? PointingText.OffNadir(Number(OffNadir), Has(Azimuth) ? Number(Azimuth) : 0.0) : new CameraPointing();

        SurfacePlace ReadPlace(string latitude, string longitude, string height) =>
            PlaceText.Place(Number(latitude), Number(longitude), Has(height) ? Read(height, PlaceText.ParseHeight) : (0.0, true));

        double Number(string column) => Read(column, text => NumberText.TryParse(text, out double number)
            ? number
            : throw new BadInputException($"{NumberText.ProblemWith(text)}."));

        T Read<T>(string column, Func<string, T> parse)
        {
            try
            {
                return parse(values[_columns[column]]);
            }
            catch (BadInputException exception)
            {
                throw new BadInputException($"{_fileName}, line {lineNumber}, column {column}: {exception.Message}", exception);
            }
        }

        T Checked<T>(Func<T> make)
        {
            try
            {
                return make();
            }
            catch (BadInputException exception) when (!exception.Message.StartsWith($"{_fileName}, line ", StringComparison.Ordinal))
            {
                throw new BadInputException($"{_fileName}, line {lineNumber}: {exception.Message}", exception);
            }
        }
    }

    /// <summary>The fields of a line, without the quotes that spreadsheets put around them.</summary>
    private static string[] Fields(string line) =>
        [.. line.Split(',', StringSplitOptions.TrimEntries).Select(field => field is ['"', .. string inner, '"'] ? inner.Trim() : field)];

    private bool Has(string column) => _columns.ContainsKey(column);

    /// <summary>Refuses columns that do not make a state, or say a thing twice.</summary>
    private void CheckColumns(int line)
    {
        Require(Has(Time), line, "column time is missing: MJD or ISO 8601.");
        Require(
            Place.Any(Has) != Position.Any(Has), line,
            "a position is either lat, lon, height (degrees, m over the sphere or terrain+m) or x, y, z (m). Name one of them.");
        RequireAll(Place, line);
        RequireAll(Position, line);
        RequireAll(Quaternion, line);
        RequireAll(Target, line);
        RequireAll(Motion, line);
        RequireWith(LookHeight, Target[0], line);
        RequireWith(Azimuth, OffNadir, line);
        Require(!(Has(Target[0]) && Has(OffNadir)), line, "look_lat and off_nadir both say where the camera looks. Remove one of them.");
        string[] withoutQuaternion = [Target[0], OffNadir, Roll, Up];
        Require(
            !Has(Quaternion[0]) || !withoutQuaternion.Any(Has), line,
            $"qx, qy, qz, qw already say how the camera points. Remove them, or {withoutQuaternion.FirstOrDefault(Has)}.");
    }

    private void RequireAll(string[] columns, int line) => Require(
        !columns.Any(Has) || columns.All(Has), line,
        $"column {columns.FirstOrDefault(column => !Has(column))} is missing: {string.Join(", ", columns)} go together.");

    private void RequireWith(string column, string other, int line) => Require(
        !Has(column) || Has(other), line, $"column {column} needs {other}. Add it, or remove {column}.");

    private void Require(bool isRight, int line, string problem)
    {
        if (!isRight)
        {
            throw Wrong(line, problem);
        }
    }

    private BadInputException Wrong(int line, string problem) => new($"{_fileName}, line {line}: {problem}");
}
