using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Adapters.Input;

/// <summary>Makes the states of a batch file's lines.</summary>
/// <param name="said">How the numbers are meant.</param>
/// <param name="frame">Turns positions and attitudes into those of MOON_ME.</param>
/// <param name="scene">Terrain, Sun and the Moon's turning, for what refers to them.</param>
internal sealed class BatchStates(BatchColumns columns, BatchConventions said, BatchFrame frame, ISceneGeometry scene)
{
    private const double MetresPerKilometre = 1000.0;

    private readonly List<int> _hiddenTargets = [];
    private ulong _step;

    /// <summary>Numbers of the lines, read so far, whose camera looks at a place that the Moon hides.</summary>
    public IReadOnlyList<int> HiddenTargets => _hiddenTargets;

    /// <summary>degrees: the greatest Euler angle so far.</summary>
    public double GreatestEulerAngle { get; private set; }

    /// <summary>Reads a line.</summary>
    /// <param name="line">The values, separated by commas.</param>
    /// <param name="lineNumber">Number of the line, from 1.</param>
    /// <exception cref="BadInputException">A value is wrong; the message is to follow the number of the line.</exception>
    public SpacecraftState Read(ReadOnlySpan<char> line, int lineNumber)
    {
        string[] values = BatchColumns.Fields(line.ToString());
        if (values.Length != columns.Count)
        {
            throw new BadInputException($"{values.Length} values, {columns.Count} columns. Complete, shorten or remove the line.");
        }

        _step++;
        BatchRow row = new(columns, values);
        Instant time = TimeOf(row);
        Vector3D position = PositionBodyFixed(row, time);
        Vector3D? sun = row.Has(BatchNames.Sun[0]) ? SunOf(row, time) : null;
        return new SpacecraftState(time, position, MoonFromCamera(row, time, position, SceneWithSun.Of(scene, sun), lineNumber))
        {
            Motion = row.Has(BatchNames.Motion[3]) ? CameraMotion.FromNumbers(row.Numbers(BatchNames.Motion)) : null,
            SunPositionBodyFixed = sun,
            Noise = row.Has(BatchNames.Noise) ? row.Read(BatchNames.Noise, text => NoiseSeedText.Parse(text, _step)) : null,
            ExposureFactor = row.Has(BatchNames.Exposure)
                ? row.Read(BatchNames.Exposure, _ => SpacecraftState.CheckedExposure(row.Number(BatchNames.Exposure)))
                : null,
        };
    }

    /// <summary>Makes a state of seven numbers, or of thirteen with the motion.</summary>
    /// <param name="numbers">Those behind the time, in their order.</param>
    /// <param name="frame">Turns positions and attitudes into those of MOON_ME.</param>
    /// <exception cref="BadInputException">They are not a state.</exception>
    public static SpacecraftState Of(Instant time, ReadOnlySpan<double> numbers, BatchFrame frame)
    {
        int count = SpacecraftState.NumberNames.Count - 1;
        if (numbers.Length > count && !frame.IsBodyFixed)
        {
            throw new BadInputException(
                $"{string.Join(", ", CameraMotion.NumberNames)} are those over the turning Moon, in frame moon-me only. Remove them, or "
                    + "change the frame.");
        }

        return new SpacecraftState(
            time, frame.PositionBodyFixed(time, new Vector3D(numbers[0], numbers[1], numbers[2])), frame.OfQuaternion(time, numbers[3..7]))
        {
            Motion = numbers.Length > count ? CameraMotion.FromNumbers(numbers[count..]) : null,
        };
    }

    private Instant TimeOf(BatchRow row) => row.Has(BatchNames.Seconds)
        ? scene.TimeScale.InstantOf(said.Epoch!.Value) + Duration.OfDecimal(row.Number(BatchNames.Seconds))
        : row.Read(BatchNames.Time, text => scene.TimeScale.InstantOf(TimeText.Parse(text)));

    private Vector3D PositionBodyFixed(BatchRow row, Instant time)
    {
        if (row.Has(BatchNames.NamedPlace) || row.Has(BatchNames.Place[0]))
        {
            return PlaceOf(row, BatchNames.NamedPlace, BatchNames.Place, HeightOf(row))
                .ToPositionBodyFixed(scene.GroundRadius, scene.ReferenceRadius);
        }

        bool isMetres = row.Has(BatchNames.Position[0]);
        double[] numbers = row.Numbers(isMetres ? BatchNames.Position : BatchNames.PositionKilometres);
        Vector3D position = new(numbers[0], numbers[1], numbers[2]);
        return frame.PositionBodyFixed(time, isMetres ? position : MetresPerKilometre * position);
    }

    private Vector3D SunOf(BatchRow row, Instant time)
    {
        double[] numbers = row.Numbers(BatchNames.Sun);
        return row.Read(
            BatchNames.Sun[0],
            _ => frame.PositionBodyFixed(time, SpacecraftState.CheckedSun(new Vector3D(numbers[0], numbers[1], numbers[2]))));
    }

    private static (double Height, bool IsOverTerrain) HeightOf(BatchRow row) =>
        row.Has(BatchNames.Height) ? row.Read(BatchNames.Height, PlaceText.ParseHeight)
        : row.Has(BatchNames.Altitude) ? (row.Number(BatchNames.Altitude), false)
        : (MetresPerKilometre * row.Number(BatchNames.HeightKilometres), false);

    private UnitQuaternion MoonFromCamera(
        BatchRow row, Instant time, Vector3D position, ISceneGeometry withSun, int lineNumber)
    {
        if (row.Has(BatchNames.Quaternion[0]))
        {
            return frame.OfQuaternion(time, row.Numbers(BatchNames.Quaternion));
        }

        if (row.Has(BatchNames.Matrix[0]))
        {
            return frame.OfMatrix(time, row.Numbers(BatchNames.Matrix));
        }

        if (row.Has(BatchNames.Euler[0]))
        {
            double[] degrees = row.Numbers(BatchNames.Euler);
            GreatestEulerAngle = Math.Max(GreatestEulerAngle, degrees.Max(Math.Abs));
            return frame.MoonFromCamera(time, said.Euler!.Value.FrameFromBody([.. degrees.Select(double.DegreesToRadians)]));
        }

        CameraPointing pointing = PointingOf(row);
        UnitQuaternion pointed = pointing.MoonFromCamera(position, time, withSun);
        if (pointing.IsTargetHidden(position, withSun))
        {
            _hiddenTargets.Add(lineNumber);
        }

        return pointed;
    }

    /// <summary>The place that a column names, or that two columns give by latitude and longitude.</summary>
    private SurfacePlace PlaceOf(BatchRow row, string named, string[] numbers, (double Height, bool IsOverTerrain) height) =>
        row.Has(named)
            ? row.Read(named, name => PlaceText.Named(name, scene.Body, height))
            : PlaceText.Place(row.Number(numbers[0]), row.Number(numbers[1]), height);

    private CameraPointing PointingOf(BatchRow row)
    {
        CameraPointing direction = new();
        if (row.Has(BatchNames.Target[0]) || row.Has(BatchNames.LookAt))
        {
            direction = new CameraPointing
            {
                Kind = BoresightKind.Place,
                Target = PlaceOf(
                    row, BatchNames.LookAt, BatchNames.Target,
                    row.Has(BatchNames.LookHeight) ? row.Read(BatchNames.LookHeight, PlaceText.ParseHeight) : (0.0, true)),
            };
        }
        else if (row.Has(BatchNames.OffNadir))
        {
            direction = PointingText.OffNadir(
                row.Number(BatchNames.OffNadir), row.Has(BatchNames.Azimuth) ? row.Number(BatchNames.Azimuth) : 0.0);
        }

        return direction with
        {
            Roll = row.Has(BatchNames.Roll) ? double.DegreesToRadians(row.Number(BatchNames.Roll)) : 0.0,
            Up = row.Has(BatchNames.Up) ? row.Read(BatchNames.Up, PointingText.ParseUp) : UpDirection.Zenith,
        };
    }
}

/// <summary>One line of a batch file with named columns.</summary>
internal sealed class BatchRow(BatchColumns columns, string[] values)
{
    /// <summary>Whether there is a column.</summary>
    public bool Has(string name) => columns.Has(name);

    /// <summary>The number in a column.</summary>
    /// <exception cref="BadInputException">It is none; the message begins with the column's name.</exception>
    public double Number(string name) => Read(name, text => NumberText.TryParse(text, out double number)
        ? number
        : throw new BadInputException($"{NumberText.ProblemWith(text)}."));

    /// <summary>The numbers in several columns.</summary>
    /// <exception cref="BadInputException">One is none; the message begins with the column's name.</exception>
    public double[] Numbers(IReadOnlyList<string> names) => [.. names.Select(Number)];

    /// <summary>What is in a column.</summary>
    /// <exception cref="BadInputException">It is wrong; the message begins with the column's name.</exception>
    public T Read<T>(string name, Func<string, T> parse)
    {
        (int index, string written) = columns.Of(name);
        try
        {
            return parse(values[index]);
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($", column {written}: {exception.Message}", exception);
        }
    }
}
