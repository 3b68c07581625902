using Msisf.Core.Numerics;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>Orientations of a spacecraft that turns by 1e-3 rad/s, written by CSPICE in each type of CK.</summary>
internal static class CkSamples
{
    public const int Count = 240;

    private const double Second = TestClock.TicksPerSecond;

    private static readonly byte[] Frame = SpiceItself.Bytes("J2000");
    private static readonly byte[] Id = SpiceItself.Bytes("test");

    public static string[] Kinds { get; } =
        ["1", "1 rates", "2", "3", "3 rates", "4", "5 subtype 0", "5 subtype 1", "5 subtype 2", "5 subtype 3", "6", "6 earlier"];

    /// <summary>Unevenly spaced, about 10 s.</summary>
    public static double[] Ticks { get; } =
        [.. Enumerable.Range(0, Count).Select(i => Math.Floor(TestClock.FirstTick + (Second * ((10.0 * i) + (3.0 * Math.Sin(i))))))];

    public static void Write(int handle, string kind)
    {
        (double first, double last, int instrument) = (Ticks[0], Ticks[^1], TestClock.Instrument);
        int hasRates = kind is "1 rates" or "3 rates" or "6" or "6 earlier" || kind.StartsWith('5') ? 1 : 0;
        double[] quaternions = [.. Ticks.SelectMany((tick, i) => Quaternion(tick, i % 3 == 1 && kind[0] is '1' or '3'))];
        double[] rates = [.. Enumerable.Range(0, 3 * Count).Select(i => 1e-3 * (1.0 + (0.3 * Math.Sin(i))))];
        double[] starts = [Ticks[0], Ticks[60], Ticks[61], Ticks[150]];
        switch (kind[0])
        {
            case '1':
                SpiceItself.ckw01_c(handle, first, last, instrument, Frame, hasRates, Id, Count, Ticks, quaternions, rates);
                break;
            case '2':
                double[] stops = [.. Ticks.Select((tick, i) => i + 1 < Count ? tick + (0.7 * (Ticks[i + 1] - tick)) : tick + Second)];
                double[] speeds = [.. Enumerable.Repeat(1.0 / Second, Count)];
                SpiceItself.ckw02_c(handle, first, stops[^1], instrument, Frame, Id, Count, Ticks, stops, quaternions, rates, speeds);
                break;
            case '3':
                SpiceItself.ckw03_c(
                    handle, first, last, instrument, Frame, hasRates, Id, Count, Ticks, quaternions, rates, starts.Length, starts);
                break;
            case '4':
                WriteChebyshev(handle);
                break;
            case '5':
                int subtype = kind[^1] - '0';
                SpiceItself.ckw05_c(
                    handle, subtype, subtype % 2 == 0 ? 7 : 5, first, last, instrument, Frame, 1, Id, Count, Ticks,
                    [.. Ticks.SelectMany(tick => Packet(tick, subtype))], TestClock.SecondsPerTick, starts.Length, starts);
                break;
            default:
                WritePieces(handle, isLaterAtBorder: kind == "6" ? 1 : 0);
                break;
        }
    }

    /// <summary>Scalar first; the axis and the rate change slowly.</summary>
    private static double[] Quaternion(double tick, bool isNegative = false)
    {
        double seconds = (tick - TestClock.FirstTick) / Second;
        UnitQuaternion q = UnitQuaternion.FromAxisAngle(new Vector3D(1.0, Math.Sin(1e-3 * seconds), 0.3), (8e-4 * seconds) + 0.4)
            * UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, 0.2 * Math.Sin(2e-3 * seconds));
        double sign = isNegative ? -1.0 : 1.0;
        return [sign * q.W, sign * q.X, sign * q.Y, sign * q.Z];
    }

    /// <summary>A packet of types 5 and 6: quaternion, angular velocity and their derivatives, as the subtype has them.</summary>
    private static double[] Packet(double tick, int subtype)
    {
        double step = 0.1 * Second;
        double[] rate =
        [
            .. Quaternion(tick + step).Zip(
                Quaternion(tick - step), (after, before) => (after - before) / (2.0 * step * TestClock.SecondsPerTick)),
        ];
        double[] turn = [1e-3, 2e-4, 3e-4];
        return subtype switch
        {
            0 => [.. Quaternion(tick), .. rate],
            1 => Quaternion(tick),
            2 => [.. Quaternion(tick), .. rate, .. turn, 0.0, 0.0, 0.0],
            _ => [.. Quaternion(tick), .. turn],
        };
    }

    /// <summary>
    /// Intervals of 20 s each with a gap of 2 s; series of different lengths that are no exact quaternions. One packet a call: of several
    /// the writer of CSPICE N0067 overwrites the second one's middle before it has moved it.
    /// </summary>
    private static void WriteChebyshev(int handle)
    {
        Random random = new(4);
        int count = 100;
        double[] starts = [.. Enumerable.Range(0, count).Select(i => TestClock.FirstTick + (22.0 * Second * i))];
        (double first, double last) = (starts[0], starts[^1] + (20.0 * Second));
        (int instrument, int hasRates, int one) = (TestClock.Instrument, 0, 1);
        SpiceItself.ckw04b_(ref handle, ref first, ref instrument, Frame, ref hasRates, Id, Frame.Length - 1, Id.Length - 1);
        for (int i = 0; i < count; i++)
        {
            int[] lengths = [3 + (i % 4), 4, 5 + (i % 2), 3, 0, 0, 0];
            double[] q = Quaternion(starts[i] + (10.0 * Second));
            double[] packet =
            [
                starts[i] + (10.0 * Second), 10.0 * Second, .. lengths.Select(length => (double)length),
                .. Enumerable.Range(0, 4).SelectMany(k => (double[])
                    [q[k], .. Enumerable.Range(1, lengths[k] - 1).Select(j => 0.01 * (random.NextDouble() - 0.5) / j)]),
            ];
            SpiceItself.ckw04a_(ref handle, ref one, [packet.Length], packet, [starts[i]]);
        }

        SpiceItself.ckw04e_(ref handle, ref last);
    }

    /// <summary>Pieces of all four subtypes; the second one ends before the third begins.</summary>
    private static void WritePieces(int handle, int isLaterAtBorder)
    {
        (int First, int End)[] pieces = [(0, 61), (60, 111), (120, 181), (180, Count)];
        int[] subtypes = [0, 1, 3, 2];
        int[] degrees = [7, 5, 9, 3];
        double[] bounds = [Ticks[0], Ticks[60], Ticks[120], Ticks[180], Ticks[^1]];
        double[] ticks = [.. pieces.SelectMany(piece => Ticks[piece.First..piece.End])];
        double[] packets =
            [.. pieces.SelectMany((piece, i) => Ticks[piece.First..piece.End].SelectMany(tick => Packet(tick, subtypes[i])))];
        (int instrument, int hasRates, int count) = (TestClock.Instrument, 1, pieces.Length);
        (double first, double last) = (Ticks[0], Ticks[^1]);
        SpiceItself.ckw06_(
            ref handle, ref instrument, Frame, ref hasRates, ref first, ref last, Id, ref count,
            [.. pieces.Select(piece => piece.End - piece.First)], subtypes, degrees, packets,
            [.. Enumerable.Repeat(TestClock.SecondsPerTick, count)], ticks, bounds, ref isLaterAtBorder, Frame.Length - 1, Id.Length - 1);
    }
}
