using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Illumination;

/// <summary>Compares horizons with the Sun's and the Earth's paths, sixteen steps at a time. Each thread has its own.</summary>
internal sealed class LightFinder
{
    private const int Lanes = LightTimes.Lanes;

    /// <summary>Above it a part of a disc is all of it but for rounding.</summary>
    private const float Whole = 1.0f - 1e-6f;

    private readonly DiscOfLight _disc = new(isDarkened: true);
    private readonly DiscOfLight _plain = new(isDarkened: false);
    private readonly LightTimes _sun;
    private readonly LightTimes _earth;
    private readonly float[] _flux;
    private readonly Vector3D _fixedLocal;
    private readonly double _nightLimit;
    private readonly Limits _aroundSun;
    private readonly Limits _aroundEarth;

    /// <summary>Prepares an interval.</summary>
    /// <param name="sun">The Sun's path.</param>
    /// <param name="earth">The Earth's.</param>
    /// <param name="fluxAtAu">W/m^2 at one astronomical unit.</param>
    /// <param name="fixedLocal">Normal of the chosen plane along east, north and up, length 1.</param>
    /// <param name="nightLimit">Steps: longer times without Sun are counted.</param>
    /// <param name="columns">Columns of a turn of horizons.</param>
    public LightFinder(LightTimes sun, LightTimes earth, double fluxAtAu, Vector3D fixedLocal, double nightLimit, int columns)
    {
        const double AstronomicalUnit = 149_597_870_700.0; // m, IAU 2012 Resolution B2
        (_sun, _earth, _fixedLocal, _nightLimit) = (sun, earth, fixedLocal, nightLimit);
        _flux = [.. sun.Distances.Select(distance => (float)(fluxAtAu * AstronomicalUnit * AstronomicalUnit / (distance * distance)))];
        Table = new HorizonTable(columns);
        (_aroundSun, _aroundEarth) = (new Limits(columns), new Limits(columns));
    }

    /// <summary>The horizon with which is compared.</summary>
    public HorizonTable Table { get; }

    /// <summary>Decides what the horizon's error leaves open; null to trust the horizon.</summary>
    public ExactLight? Exact { get; init; }

    /// <summary>The visible part of the Sun's disc at each step of the last place, by area; null if it is not wanted.</summary>
    public float[]? Parts { get; init; }

    /// <summary>The light of a place whose horizon is in <see cref="Table"/>.</summary>
    /// <param name="frame">The place.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public PlaceLight Of(LocalFrame frame)
    {
        Table.FindLimits();
        float highest = Table.Tangents.Max();
        _aroundSun.Find(Table, _sun, highest);
        _aroundEarth.Find(Table, _earth, highest);
        StepRuns runs = new(_nightLimit);
        Vector512<float> sumTracking = default, sumHorizontal = default, sumFixed = default, sumArea = default;
        Vector512<float> mostTracking = default, mostHorizontal = default, mostFixed = default;
        (int lit, int earth, int whole, int both) = (0, 0, 0, 0);
        Seen sun = default;
        Seen other = default;
        for (int step = 0; step < _sun.Count; step += Lanes)
        {
            uint valid = _sun.Count - step >= Lanes ? 0xFFFFu : (1u << (_sun.Count - step)) - 1;
            See(frame, _sun, step, ref sun);
            (uint full, uint open) = _aroundSun.Compare(sun, Vector512.LoadUnsafe(ref _sun.Slope[step]));
            full &= valid;
            Vector512<float> isFull = LaneMasks.Of(full);
            Vector512<float> area = isFull;
            Vector512<float> flux = Vector512.LoadUnsafe(ref _flux[step]);
            Vector512<float> length = Vector512.Sqrt((sun.East * sun.East) + (sun.North * sun.North) + (sun.Up * sun.Up));
            Vector512<float> tracking = isFull * flux;
            Vector512<float> horizontal = tracking * Vector512.MaxNative(sun.Up / length, Vector512<float>.Zero);
            Vector512<float> cosine = Vector512.MaxNative(
                ((Vector512.Create((float)_fixedLocal.X) * sun.East) + (Vector512.Create((float)_fixedLocal.Y) * sun.North)
                    + (Vector512.Create((float)_fixedLocal.Z) * sun.Up)) / length, Vector512<float>.Zero);
            uint visible = full;
            for (uint left = open & valid; left != 0; left &= left - 1)
            {
                int lane = BitOperations.TrailingZeroCount(left);
                (float part, float light, float up) = OfSun(frame, sun, step, lane, out bool isVisible);
                if (isVisible)
                {
                    visible |= 1u << lane;
                    area = area.WithElement(lane, part);
                    tracking = tracking.WithElement(lane, flux[lane] * light);
                    horizontal = horizontal.WithElement(lane, flux[lane] * Math.Max(0.0f, up));
                }
            }

            Vector512<float> onFixed = tracking * cosine;
            (sumArea, sumTracking) = (sumArea + area, sumTracking + tracking);
            (sumHorizontal, sumFixed) = (sumHorizontal + horizontal, sumFixed + onFixed);
            mostTracking = Vector512.MaxNative(mostTracking, tracking);
            mostHorizontal = Vector512.MaxNative(mostHorizontal, horizontal);
            mostFixed = Vector512.MaxNative(mostFixed, onFixed);
            if (Parts is { } parts)
            {
                area.StoreUnsafe(ref parts[step]);
            }

            See(frame, _earth, step, ref other);
            (uint wholeEarth, uint openEarth) = _aroundEarth.Compare(other, Vector512.LoadUnsafe(ref _earth.Slope[step]));
            uint anyEarth = wholeEarth &= valid;
            for (uint left = openEarth & valid; left != 0; left &= left - 1)
            {
                int lane = BitOperations.TrailingZeroCount(left);
                float part = _plain.AreaOver(HorizonIn(_plain, other, lane, _earth.Slope[step + lane]));
                anyEarth |= part > 0.0f ? 1u << lane : 0;
                wholeEarth |= part >= Whole ? 1u << lane : 0;
            }

            runs.Add(visible, Math.Min(Lanes, _sun.Count - step));
            lit += BitOperations.PopCount(visible);
            earth += BitOperations.PopCount(anyEarth);
            whole += BitOperations.PopCount(wholeEarth);
            both += BitOperations.PopCount(visible & anyEarth);
        }

        runs.End();
        return new PlaceLight
        {
            LitSteps = lit,
            DiscPart = Vector512.Sum(sumArea) / _sun.Count,
            Dark = runs.Dark,
            Light = runs.Light,
            Nights = runs.Nights,
            Horizontal = new Irradiance(Vector512.Sum(sumHorizontal) / _sun.Count, LaneMasks.Max(mostHorizontal)),
            Tracking = new Irradiance(Vector512.Sum(sumTracking) / _sun.Count, LaneMasks.Max(mostTracking)),
            Fixed = new Irradiance(Vector512.Sum(sumFixed) / _sun.Count, LaneMasks.Max(mostFixed)),
            EarthSteps = earth,
            WholeEarthSteps = whole,
            BothSteps = both,
        };
    }

    /// <summary>Where a body is seen at sixteen steps.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void See(in LocalFrame frame, LightTimes body, int step, ref Seen seen)
    {
        Vector512<float> x = Vector512.LoadUnsafe(ref body.X[step]);
        Vector512<float> y = Vector512.LoadUnsafe(ref body.Y[step]);
        Vector512<float> z = Vector512.LoadUnsafe(ref body.Z[step]);
        seen.East = Along(frame.East, x, y, z);
        seen.North = Along(frame.North, x, y, z);
        seen.Up = Along(frame.Up, x, y, z)
            - (Vector512.Create((float)frame.PositionBodyFixed.Length) * Vector512.LoadUnsafe(ref body.PerMetre[step]));
        Vector512<float> across = Vector512.Sqrt((seen.East * seen.East) + (seen.North * seen.North));
        seen.Tangent = seen.Up / Vector512.MaxNative(across, Vector512.Create(1e-6f));
        seen.Column = AzimuthLanes.Turns(seen.East, seen.North) * Vector512.Create((float)Table.Columns);
    }

    private static Vector512<float> Along(Vector3D axis, Vector512<float> x, Vector512<float> y, Vector512<float> z) =>
        (Vector512.Create((float)axis.X) * x) + (Vector512.Create((float)axis.Y) * y) + (Vector512.Create((float)axis.Z) * z);

    /// <summary>The horizon at the strips of a disc, over its middle in radii.</summary>
    private Vector512<float> HorizonIn(DiscOfLight disc, in Seen seen, int lane, float slope)
    {
        float tangent = seen.Tangent[lane];
        float width = slope * MathF.Sqrt(1.0f + (tangent * tangent)) * (float)(Table.Columns / (2.0 * Math.PI));
        Vector512<float> horizon = Table.At(Vector512.Create(seen.Column[lane]) + (disc.Offsets * Vector512.Create(width)));
        Vector512<float> middle = Vector512.Create(tangent);
        return (horizon - middle) / ((Vector512<float>.One + (horizon * middle)) * Vector512.Create(slope));
    }

    /// <summary>Part of the Sun's area and light, and its light times the sine of its elevation.</summary>
    private (float Area, float Light, float Up) OfSun(in LocalFrame frame, in Seen seen, int step, int lane, out bool isVisible)
    {
        float slope = _sun.Slope[step + lane];
        float tangent = seen.Tangent[lane];
        float cosine = 1.0f / MathF.Sqrt(1.0f + (tangent * tangent));
        if (slope == 0.0f)
        {
            float over = tangent - Table.At(Vector512.Create(seen.Column[lane]))[0];
            isVisible = Exact is not null && MathF.Abs(over) * cosine * cosine < ExactLight.Doubt
                ? Exact.IsVisible(frame, step + lane)
                : over > 0.0f;
            return isVisible ? (1.0f, 1.0f, tangent * cosine) : default;
        }

        Vector512<float> horizon = HorizonIn(_disc, seen, lane, slope);
        float area = _disc.AreaOver(horizon);
        isVisible = Exact is not null && area * slope < 2.0f * ExactLight.Doubt ? Exact.IsVisible(frame, step + lane) : area > 0.0f;
        if (!isVisible)
        {
            return default;
        }

        float level = -tangent / slope;
        if (area >= Whole && level <= -1.0f)
        {
            return (1.0f, 1.0f, tangent * cosine);
        }

        (float light, float moment) = _disc.LightOver(horizon);
        if (level > -1.0f)
        {
            (float above, moment) = _disc.LightOver(Vector512.MaxNative(horizon, Vector512.Create(level)));
            return (area, light, ((above * tangent) + (moment * slope)) * cosine);
        }

        return (area, light, ((light * tangent) + (moment * slope)) * cosine);
    }

    /// <summary>A body as it is seen at sixteen steps.</summary>
    private struct Seen
    {
        public Vector512<float> East;
        public Vector512<float> North;
        public Vector512<float> Up;
        public Vector512<float> Tangent;
        public Vector512<float> Column;
    }

    /// <summary>The horizon's limits around the discs of a body.</summary>
    private sealed class Limits(int columns)
    {
        private readonly float[] _least = new float[columns / HorizonBuffer.Group];
        private readonly float[] _most = new float[columns / HorizonBuffer.Group];
        private float _highest;

        public void Find(HorizonTable table, LightTimes body, float highest)
        {
            _highest = highest;
            double tangent = Math.Max(0.0, highest) + (2.0 * body.MaxSlope);
            double width = 1.05 * body.MaxSlope * Math.Sqrt(1.0 + (tangent * tangent));
            double group = 2.0 * Math.PI * HorizonBuffer.Group / columns;
            table.Widen(Math.Min((int)Math.Ceiling(width / group), (_least.Length / 2) - 1), _least, _most);
        }

        /// <summary>The lanes whose disc is whole, and those for which the limits do not tell.</summary>
        public (uint Full, uint Open) Compare(in Seen seen, Vector512<float> slope)
        {
            Vector512<int> group = Vector512.ShiftRightArithmetic(
                Vector512.ConvertToInt32(seen.Column), BitOperations.Log2(HorizonBuffer.Group)) & Vector512.Create(_least.Length - 1);
            Vector512<float> half = Vector512.Create(1.05f) * (slope + Vector512.Create(ExactLight.Doubt))
                * (Vector512<float>.One + (seen.Tangent * seen.Tangent));
            Vector512<float> lower = seen.Tangent - half;
            Vector512<float> isFull = (Vector512.GreaterThan(lower, HorizonTable.Gather(_most, group))
                | Vector512.GreaterThan(lower, Vector512.Create(_highest)))
                & Vector512.GreaterThan(Vector512.Abs(seen.Tangent), half);
            Vector512<float> isNone = Vector512.LessThan(seen.Tangent + half, HorizonTable.Gather(_least, group));
            uint full = (uint)isFull.ExtractMostSignificantBits();
            return (full, ~(full | (uint)isNone.ExtractMostSignificantBits()) & 0xFFFF);
        }
    }
}
