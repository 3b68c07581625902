using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>What gives MOON_ME among some kernels; a second, different orientation of the Moon is an error.</summary>
public static class LunarOrientation
{
    /// <summary>NAIF's numbers of the Moon's frames, by the ephemerides that they belong to.</summary>
    private const int FirstNumber = 31000;
    private const int LastNumber = 31999;

    /// <summary>rad: 2 m on the ground; the ephemerides since DE403 differ by more, copies of one kernel by nothing.</summary>
    private const double SameAngle = 1e-9;

    /// <summary>Looks for the orientation.</summary>
    /// <returns>Which kernels give it: "orientation 31006 of moon_pa_de421_1900-2050.bpc, by moon_080317.tf".</returns>
    /// <exception cref="BadInputException">There is none, or there are two that differ.</exception>
    public static string Of(KernelCatalogue catalogue)
    {
        List<string> variables = [];
        BodyFixedFrame frame = FrameKernel.ReadBodyFixedFrame(catalogue.Pool, CelestialBody.Moon.Frame, variables);
        foreach (string name in variables)
        {
            if (catalogue.Pool.FirstSource(name) is { } first)
            {
                throw new BadInputException(
                    $"Two kernels define {CelestialBody.Moon.Frame} differently: {name} is set in {first} and in "
                        + $"{catalogue.Pool.Existing(name).Source}. Leave one of them out.");
            }
        }

        (DafFile File, DafSummary Summary)[] segments =
        [
            .. catalogue.Files.Where(file => file.IdWord == "DAF/PCK").SelectMany(file => file.Summaries.Select(summary => (file, summary)))
                .Where(segment => segment.summary.Integers[0] is >= FirstNumber and <= LastNumber),
        ];
        if (segments.FirstOrDefault(segment => segment.Summary.Integers[0] != frame.OrientationBody) is { File: { } other } second)
        {
            throw new BadInputException(Invariant(
                $"{other.FileName} has a second orientation of the Moon ({second.Summary.Integers[0]}); {CelestialBody.Moon.Frame} is "
                    + $"defined by {frame.OrientationBody}. Leave out the kernel that is not meant, with its frame kernel."));
        }

        RefuseDifferent(segments);
        string[] binary = [.. segments.Select(segment => Path.GetFileName(segment.File.FileName)).Distinct()];
        string[] text = [.. variables.Select(name => FileOf(catalogue.Pool.Existing(name).Source)).Distinct()];
        return Invariant($"orientation {frame.OrientationBody} of {string.Join(", ", binary)}, by {string.Join(", ", text)}");
    }

    /// <summary>Two files may have the same orientation, as slices of one kernel do; where both hold, they must agree.</summary>
    private static void RefuseDifferent((DafFile File, DafSummary Summary)[] segments)
    {
        for (int i = 1; i < segments.Length; i++)
        {
            (DafFile file, DafSummary summary) = segments[i];
            (DafFile before, DafSummary earlier) = segments[i - 1];
            double time = 0.5 * (Math.Max(summary.Interval.Start, earlier.Interval.Start)
                + Math.Min(summary.Interval.End, earlier.Interval.End));
            if (file == before || !summary.Interval.Contains(time) || !earlier.Interval.Contains(time))
            {
                continue;
            }

            Vector3D difference = Angles(file, summary, time) - Angles(before, earlier, time);
            if (difference.Length > SameAngle)
            {
                throw new BadInputException(
                    $"{before.FileName} and {file.FileName} have different orientations of the Moon. Leave one of them out.");
            }
        }
    }

    private static Vector3D Angles(DafFile file, DafSummary summary, double time) =>
        DafSegments.Orientation(file, summary).ValueAt(time);

    /// <summary>The file's name without folders, and without the line.</summary>
    private static string FileOf(string source) => Path.GetFileName(source[..source.LastIndexOf(", line", StringComparison.Ordinal)]);
}
