using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Turns a binary kernel's summaries into segments.</summary>
internal static class DafSegments
{
    private const int J2000 = 1;
    private const int ChebyshevPositions = 2;
    private const int ChebyshevStates = 3;
    private const int ChebyshevAngles = 2;

    /// <summary>The segments of an SPK or PCK, in the order of the file.</summary>
    public static IEnumerable<IEphemerisSegment> Of(DafFile file) =>
        file.Summaries.Select(summary => file.IdWord == "DAF/SPK" ? Position(file, summary) : Orientation(file, summary));

    private static IEphemerisSegment Position(DafFile file, DafSummary summary)
    {
        (
            int target,
            int center,
            int frame,
            int type) = (summary.Integers[0], summary.Integers[1], summary.Integers[2], summary.Integers[3]);
        if (frame != J2000 || type is not (ChebyshevPositions or ChebyshevStates))
        {
            return new UnreadableSegment(target, center, summary.Interval,
                $"{file.FileName}: body {target} is given by SPK type {type} in frame {frame}; "
                    + $"the built-in reader knows the types 2 and 3 in J2000 (1)");
        }

        return new ChebyshevSegment(file, summary, target, center, seriesPerRecord: type == ChebyshevStates ? 6 : 3);
    }

    private static IEphemerisSegment Orientation(DafFile file, DafSummary summary)
    {
        (int body, int frame, int type) = (summary.Integers[0], summary.Integers[1], summary.Integers[2]);
        if (frame != J2000 || type != ChebyshevAngles)
        {
            return new UnreadableSegment(body, Center: 0, summary.Interval,
                $"{file.FileName}: orientation {body} is given by PCK type {type} in frame {frame}; "
                    + $"the built-in reader knows type 2 in J2000 (1)");
        }

        return new ChebyshevSegment(file, summary, body, center: 0, seriesPerRecord: 3);
    }
}
