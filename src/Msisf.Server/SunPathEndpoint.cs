using Msisf.Core.Time;

namespace Msisf.Server;

/// <summary>GET /v1/sun/path: where the Sun is at evenly spaced times, for the viewer's time bar.</summary>
/// <param name="frames">Knows the ephemeris.</param>
internal sealed class SunPathEndpoint(FrameService frames)
{
    private const int MostTimes = 2001;

    private static readonly string[] Names = ["from", "to", "count"];

    public static RouteText About { get; } = new("Says where the Sun is at evenly spaced times (MJD, UTC).", AnswerForm.Json)
    {
        Query = Names,
    };

    public Task AnswerAsync(HttpContext context)
    {
        IQueryCollection query = context.Request.Query;
        double from = Number(query, "from");
        double to = Number(query, "to");
        double count = Number(query, "count");
        if (!(to > from) || count is not (>= 2 and <= MostTimes) || count != Math.Floor(count))
        {
            throw new UsageException(
                $"'to' is after 'from', and 'count' a whole number from 2 to {MostTimes}; given were {Names[0]}={query["from"]}, "
                    + $"to={query["to"]}, count={query["count"]}.");
        }

        double step = (to - from) / (count - 1.0);
        Vector3D[] suns = frames.SunAt(Enumerable.Range(0, (int)count).Select(index => new ModifiedJulianDate(from + (index * step))));
        return JsonBody.SendAsync(context.Response, new
        {
            From = from,
            Step = step,
            Positions = suns.Select(sun => (double[])[sun.X, sun.Y, sun.Z]),
        });
    }

    private static double Number(IQueryCollection query, string name) =>
        query[name] is [{ } text] && double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
            && double.IsFinite(number)
            ? number
            : throw new UsageException($"'{name}' is needed once, as a number: 'from' and 'to' are MJD, 'count' is how many times.");
}
