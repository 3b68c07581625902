using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Illumination;
using Msisf.Core.Render.Options;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Illumination;

/// <summary>What <c>msis illumination</c> is to do.</summary>
internal sealed record IlluminationSettings
{
    /// <summary>Degrees: latitude and longitude of the middle, or of two corners; null for the finest model, or for points alone.</summary>
    public double[]? Place { get; init; }

    /// <summary>m: width and height around a middle; null for corners.</summary>
    public (double Width, double Height)? Size { get; init; }

    /// <summary>m; null for that of the finest model.</summary>
    public double? Cell { get; init; }

    /// <summary>Path of the list of points; null for none.</summary>
    public string? Points { get; init; }

    /// <summary>Which of its columns the user names; null for none.</summary>
    public ListColumns? Columns { get; init; }

    /// <summary>The times.</summary>
    public required TimeInterval Times { get; init; }

    /// <summary>m over the ground.</summary>
    public required IReadOnlyList<double> Heights { get; init; }

    /// <summary>Whether the Sun is a point.</summary>
    public bool IsPoint { get; init; }

    /// <summary>Whether rays decide where the horizon is not enough.</summary>
    public bool IsExact { get; init; }

    /// <summary>Degrees: angle of the fixed plane with the horizontal, azimuth of its normal from north over east; null for none.</summary>
    public (double Tilt, double Azimuth)? Plane { get; init; }

    /// <summary>Normal of the fixed plane along east, north and up; null for none.</summary>
    public Vector3D? PlaneNormal => Plane is { } plane ? NormalOf(plane.Tilt, plane.Azimuth) : null;

    /// <summary>Hours.</summary>
    public double NightLimit { get; init; }

    /// <summary>Form of the maps.</summary>
    public MapFormat Format { get; init; }

    /// <summary>Maps of LOLA's archive with which the maps are compared.</summary>
    public IReadOnlyList<string> Compared { get; init; } = [];

    /// <summary>The part of the work that is done, from 0, and how many there are.</summary>
    public (int Part, int Parts) Piece { get; init; } = (0, 1);

    /// <summary>How many threads work at once.</summary>
    public required int Threads { get; init; }

    /// <summary>Folder of the results.</summary>
    public required string Folder { get; init; }

    /// <summary>Whether to draw no progress bar.</summary>
    public bool Unattended { get; init; }

    /// <summary>The call: all options that decide what the maps hold, in a fixed order; files without their folders.</summary>
    public required string Command { get; init; }

    /// <summary>Hours from one time to the next.</summary>
    public double StepHours => Times.Step.TotalSeconds / 3600.0;

    /// <summary>Reads the options.</summary>
    /// <exception cref="UsageException">A value is wrong, or options don't go together.</exception>
    public static IlluminationSettings Read(OptionValues values)
    {
        double[]? corners = Numbers(IlluminationOptions.Corners, values, 4, 4);
        double[]? centre = IlluminationOptions.Centre.ReadIfGiven(values) is { } name && PlaceText.IsName(name)
            ? IlluminationOptions.Centre.Named(() => Coordinates(PlaceText.Named(
                name, CelestialBody.Of(SurfaceOptions.Body.Read(values)), (0.0, true))))
            : Numbers(IlluminationOptions.Centre, values, 2, 2);
        double[]? size = Numbers(IlluminationOptions.Size, values, 1, 2);
        string? points = IlluminationOptions.Points.ReadIfGiven(values);
        if ((centre is null) != (size is null) || (centre is not null && corners is not null))
        {
            throw NoPlace(string.Empty);
        }

        if (size is not null && Array.Exists(size, side => !(side > 0.0)))
        {
            throw new UsageException($"{IlluminationOptions.Size.Name} has a side that is not above 0 km.").About(IlluminationOptions.Size);
        }

        TimeInterval times = IlluminationOptions.TimeInterval.Value(() => StateText.ParseInterval(
            IlluminationOptions.TimeInterval.Name, values.Words(IlluminationOptions.TimeInterval)!));
        if (times.Count == 0 || times.Step < default(Duration))
        {
            throw new UsageException(
                $"{IlluminationOptions.TimeInterval.Name} runs backwards: the end has to come after the start, and the step above 0.")
                .About(IlluminationOptions.TimeInterval);
        }

        double[] heights = Numbers(IlluminationOptions.Heights, values, 1, 16)!;
        if (heights.Any(height => height is < 0.0 or > HorizonSurvey.MaxHeight) || heights.Distinct().Count() < heights.Length)
        {
            throw new UsageException(
                $"{IlluminationOptions.Heights.Name} is {values.Text(IlluminationOptions.Heights)}; heights of 0 to 10000 m over the "
                    + "ground are needed, each once.").About(IlluminationOptions.Heights);
        }

        double[]? plane = Numbers(IlluminationOptions.Plane, values, 2, 2);
        if (plane?[0] is < 0.0 or > 180.0)
        {
            throw new UsageException(
                $"{IlluminationOptions.Plane.Name} is {values.Text(IlluminationOptions.Plane)}; a tilt of 0 to 180 degrees is needed.")
                .About(IlluminationOptions.Plane);
        }

        return new IlluminationSettings
        {
            Place = corners ?? centre,
            Size = size is null ? null : (1000.0 * size[0], 1000.0 * size[^1]),
            Cell = IlluminationOptions.Cell.ReadIfGiven(values),
            Points = points,
            Columns = IlluminationOptions.Columns.ReadIfGiven(values) is { } columns
                ? IlluminationOptions.Columns.Named(() => ListColumns.Parse(columns))
                : null,
            Times = times,
            Heights = heights,
            IsPoint = IlluminationOptions.Sun.Read(values) == SunModel.Point,
            IsExact = IlluminationOptions.Exact.Read(values),
            Plane = plane is null ? null : (plane[0], plane[1]),
            NightLimit = IlluminationOptions.NightLimit.Read(values),
            Format = IlluminationOptions.Format.Read(values),
            Compared = ReadCompared(values, hasRegion: (corners ?? centre) is not null || points is null),
            Piece = ReadPiece(values),
            Threads = IlluminationOptions.Jobs.ReadIfGiven(values) ?? Environment.ProcessorCount,
            Folder = IlluminationOptions.Folder.Read(values),
            Unattended = RunOptions.Batch.Read(values),
            Command = string.Join(' ', [
                IlluminationOptions.Command.Name, .. IlluminationOptions.Command.Groups.SelectMany(group => group.Options).Where(
                    option => option.Role is DecidesBytes).SelectMany(option => Words(option, values))]),
        };
    }

    private static IEnumerable<string> Words(OptionSpec option, OptionValues values)
    {
        if (option is FlagSpec flag)
        {
            return flag.Read(values) ? [option.Name] : [];
        }

        if (values.Words(option) is not { } words)
        {
            return [];
        }

        IEnumerable<string> texts = (option is PathSpec ? words.Select(path => Path.GetFileName(path)) : words)
            .Select(text => text.Contains(' ', StringComparison.Ordinal) ? $"'{text}'" : text);
        return option.MayBeRepeated ? texts.SelectMany(text => (string[])[option.Name, text]) : [option.Name, .. texts];
    }

    /// <summary>The error of a call that names no place, or two.</summary>
    /// <param name="reason">Why the finest model is not the region, with a blank after it, or nothing.</param>
    public static UsageException NoPlace(string reason) => new UsageException(
        $"Where? {reason}Give {IlluminationOptions.Centre.Name} with {IlluminationOptions.Size.Name}, or "
            + $"{IlluminationOptions.Corners.Name}, or {IlluminationOptions.Points.Name}.")
        .About(IlluminationOptions.Centre, IlluminationOptions.Corners);

    private static double[] Coordinates(SurfacePlace place) => [place.LatitudeDegrees, place.LongitudeDegrees];

    private static double[]? Numbers(TextSpec option, OptionValues values, int least, int most)
    {
        if ((option.ReadIfGiven(values) ?? option.Default) is not { } text)
        {
            return null;
        }

        string[] parts = text.Split(',', StringSplitOptions.TrimEntries);
        double[] numbers = new double[parts.Length];
        for (int i = 0; i < parts.Length; i++)
        {
            if (parts.Length < least || parts.Length > most || !NumberText.TryParse(parts[i], out numbers[i]))
            {
                throw new UsageException($"{option.Name} is '{text}'; {option.ValueName} is needed.").About(option);
            }
        }

        return numbers;
    }

    private static Vector3D NormalOf(double tiltDegrees, double azimuthDegrees)
    {
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(tiltDegrees));
        (double east, double north) = Math.SinCos(double.DegreesToRadians(azimuthDegrees));
        return new Vector3D(sine * east, sine * north, cosine);
    }

    private static IReadOnlyList<string> ReadCompared(OptionValues values, bool hasRegion)
    {
        IReadOnlyList<string> compared = IlluminationOptions.Compare.ReadAll(values);
        return compared.Count == 0 || hasRegion ? compared : throw new UsageException(
            $"{IlluminationOptions.Compare.Name} compares maps: give a region by {IlluminationOptions.Centre.Name} and "
                + $"{IlluminationOptions.Size.Name} or {IlluminationOptions.Corners.Name}.").About(IlluminationOptions.Compare);
    }

    private static (int Part, int Parts) ReadPiece(OptionValues values)
    {
        if (IlluminationOptions.Piece.ReadIfGiven(values) is not { } text)
        {
            return (0, 1);
        }

        string[] parts = text.Split('/');
        return parts.Length == 2 && int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int part)
            && int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int all) && part >= 1 && part <= all
            ? (part - 1, all)
            : throw new UsageException($"{IlluminationOptions.Piece.Name} is '{text}'; K/N with K from 1 to N is needed, e.g. 3/40.")
                .About(IlluminationOptions.Piece);
    }
}
