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
    private readonly DiscOfLight[] _fineStrips = [.. Enumerable.Range(0, 4).Select(part => new DiscOfLight(isDarkened: false, part, 4))];
    private readonly DiscOfLight _plain = new(isDarkened: false);
    private readonly LightTimes _sun;
    private readonly LightTimes _earth;
    private readonly SkyPath _sunPath;
    private readonly SkyPath _earthPath;
    private readonly float[] _flux;
    private readonly float[] _area = new float[Lanes];
    private readonly float[] _tracking = new float[Lanes];
    private readonly float[] _horizontal = new float[Lanes];
    private readonly Vector3D _fixedLocal;
    private readonly double _nightLimit;
    private readonly SkyLimits _aroundSun;
    private readonly SkyLimits _aroundEarth;

    /// <summary>Prepares an interval.</summary>
    /// <param name="sun">The Sun's path.</param>
    /// <param name="earth">The Earth's.</param>
    /// <param name="fluxAtAu">W/m^2 at one astronomical unit.</param>
    /// <param name="fixedLocal">Normal of the chosen plane along east, north and up, length 1.</param>
    /// <param name="nightLimit">Steps: longer times without Sun are counted.</param>
    /// <param name="columns">Columns of a turn of horizons.</param>
    /// <param name="steepest">Tangent of the greatest elevation of a horizon.</param>
    public LightFinder(
        LightTimes sun, LightTimes earth, double fluxAtAu, Vector3D fixedLocal, double nightLimit, int columns, double steepest)
    {
        const double AstronomicalUnit = 149_597_870_700.0; // m, IAU 2012 Resolution B2
        (_sun, _earth, _fixedLocal, _nightLimit) = (sun, earth, fixedLocal, nightLimit);
        _flux = [.. sun.Distances.Select(distance => (float)(fluxAtAu * AstronomicalUnit * AstronomicalUnit / (distance * distance)))];
        Table = new HorizonTable(columns);
        (_sunPath, _earthPath) = (new SkyPath(sun, columns, steepest), new SkyPath(earth, columns, steepest));
        (_aroundSun, _aroundEarth) = (new SkyLimits(columns), new SkyLimits(columns));
    }

    /// <summary>The horizon with which is compared.</summary>
    public HorizonTable Table { get; }

    /// <summary>Decides what the horizon's error leaves open; null to trust the horizon.</summary>
    public ExactLight? Exact { get; init; }

    /// <summary>The visible part of the Sun's disc at each step of the last place, by area; null if it is not wanted.</summary>
    public float[]? Parts { get; init; }

    /// <summary>Forgets the place before, so that what is found does not depend on what this thread did before.</summary>
    public void Forget()
    {
        _sunPath.Forget();
        _earthPath.Forget();
    }

    /// <summary>The light of a place whose horizon is in <see cref="Table"/>.</summary>
    /// <param name="frame">The place.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public PlaceLight Of(LocalFrame frame)
    {
        Table.FindLimits();
        _aroundSun.Find(Table, _sun);
        _aroundEarth.Find(Table, _earth);
        (SkyShift sunShift, SkyShift earthShift) = (_sunPath.MoveTo(frame), _earthPath.MoveTo(frame));
        Vector3D upright = _sunPath.ToLocal(frame.Up);
        Vector3D plane = _sunPath.ToLocal(
            (_fixedLocal.X * frame.East) + (_fixedLocal.Y * frame.North) + (_fixedLocal.Z * frame.Up));
        StepRuns runs = new(_nightLimit);
        LightSums sums = default;
        (int lit, int earth, int whole, int both) = (0, 0, 0, 0);
        for (int step = 0; step < _sun.Count; step += Lanes)
        {
            int count = Math.Min(Lanes, _sun.Count - step);
            uint valid = (1u << count) - 1;
            uint visible = SeeSun(frame, sunShift, step, valid, upright, plane, ref sums);
            (uint wholeEarth, uint anyEarth) = SeeEarth(earthShift, step);
            (wholeEarth, anyEarth) = (wholeEarth & valid, anyEarth & valid);
            runs.Add(visible, count);
            lit += BitOperations.PopCount(visible);
            earth += BitOperations.PopCount(anyEarth);
            whole += BitOperations.PopCount(wholeEarth);
            both += BitOperations.PopCount(visible & anyEarth);
        }

        runs.End();
        return sums.ToLight(_sun.Count) with
        {
            LitSteps = lit,
            Dark = runs.Dark,
            Light = runs.Light,
            Nights = runs.Nights,
            EarthSteps = earth,
            WholeEarthSteps = whole,
            BothSteps = both,
        };
    }

    /// <summary>Adds the light of sixteen steps.</summary>
    /// <returns>At which of them any of the Sun is in view.</returns>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private uint SeeSun(
        in LocalFrame frame, in SkyShift shift, int step, uint valid, Vector3D upright, Vector3D plane, ref LightSums sums)
    {
        (uint full, uint open) = _aroundSun.Compare(_sunPath.BoxAt(step, shift));
        SeenBody sun = default;
        if (open != 0)
        {
            sun = _sunPath.At(step, shift);
            (full, open) = _aroundSun.Compare(sun, Vector512.LoadUnsafe(ref _sun.Slope[step]));
        }

        uint visible = full & valid;
        open &= valid;
        Vector512<float> area = LaneMasks.Of(visible);
        if ((visible | open) != 0)
        {
            Vector512<float> flux = Vector512.LoadUnsafe(ref _flux[step]);
            Vector512<float> tracking = area * flux;
            Vector512<float> horizontal = tracking * _sunPath.CosineTo(upright, step);
            area.StoreUnsafe(ref _area[0]);
            tracking.StoreUnsafe(ref _tracking[0]);
            horizontal.StoreUnsafe(ref _horizontal[0]);
            for (; open != 0; open &= open - 1)
            {
                int lane = BitOperations.TrailingZeroCount(open);
                (float part, float light, float up) = OfSun(frame, sun, step, lane, out bool isVisible);
                if (isVisible)
                {
                    visible |= 1u << lane;
                    _area[lane] = part;
                    _tracking[lane] = _flux[step + lane] * light;
                    _horizontal[lane] = _flux[step + lane] * Math.Max(0.0f, up);
                }
            }

            (area, tracking) = (Vector512.LoadUnsafe(ref _area[0]), Vector512.LoadUnsafe(ref _tracking[0]));
            horizontal = Vector512.LoadUnsafe(ref _horizontal[0]);

            sums.Add(area, tracking, horizontal, tracking * _sunPath.CosineTo(plane, step));
        }

        if (Parts is { } parts)
        {
            area.StoreUnsafe(ref parts[step]);
        }

        return visible;
    }

    /// <summary>The steps, of sixteen, at which all of the Earth is in view, and those at which any of it is.</summary>
    private (uint Whole, uint Any) SeeEarth(in SkyShift shift, int step)
    {
        (uint whole, uint open) = _aroundEarth.Compare(_earthPath.BoxAt(step, shift));
        if (open == 0)
        {
            return (whole, whole);
        }

        SeenBody seen = _earthPath.At(step, shift);
        Vector512<float> slope = Vector512.LoadUnsafe(ref _earth.Slope[step]);
        (whole, open) = _aroundEarth.Compare(seen, slope);
        uint any = whole;
        if (open != 0)
        {
            // The horizon passes in front of the disc's middle: the Earth is partly in view. Below 63 degrees that is simple to tell.
            Vector512<float> half = Vector512.Create(0.95f) * slope * (Vector512<float>.One + (seen.Tangent * seen.Tangent));
            Vector512<float> isPartial = Vector512.LessThan(Vector512.Abs(Table.At(seen.Column) - seen.Tangent), half)
                & Vector512.LessThan(Vector512.Abs(seen.Tangent), Vector512.Create(2.0f));
            uint partial = (uint)isPartial.ExtractMostSignificantBits() & open;
            any |= partial;
            open &= ~partial;
        }

        for (; open != 0; open &= open - 1)
        {
            int lane = BitOperations.TrailingZeroCount(open);
            float part = _plain.AreaOver(HorizonIn(_plain, seen, lane, slope[lane]));
            any |= part > 0.0f ? 1u << lane : 0;
            whole |= part >= Whole ? 1u << lane : 0;
        }

        return (whole, any);
    }

    /// <summary>The horizon at the strips of a disc, over its middle in radii.</summary>
    private Vector512<float> HorizonIn(DiscOfLight disc, in SeenBody seen, int lane, float slope)
    {
        float tangent = seen.Tangent[lane];
        float width = slope * MathF.Sqrt(1.0f + (tangent * tangent)) * (float)(Table.Columns / (2.0 * Math.PI));
        Vector512<float> horizon = Table.At(Vector512.Create(seen.Column[lane]) + (disc.Offsets * Vector512.Create(width)));
        Vector512<float> middle = Vector512.Create(tangent);
        return (horizon - middle) / ((Vector512<float>.One + (horizon * middle)) * Vector512.Create(slope));
    }

    /// <summary>The visible part of a disc over 64 strips.</summary>
    private float FineAreaOf(in SeenBody seen, int lane, float slope)
    {
        float area = 0.0f;
        foreach (DiscOfLight strips in _fineStrips)
        {
            area += strips.AreaOver(HorizonIn(strips, seen, lane, slope));
        }

        return area;
    }

    /// <summary>Part of the Sun's area and light, and its light times the sine of its elevation.</summary>
    private (float Area, float Light, float Up) OfSun(in LocalFrame frame, in SeenBody seen, int step, int lane, out bool isVisible)
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
        float area = Parts is null ? _disc.AreaOver(horizon) : FineAreaOf(seen, lane, slope);
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
        if (level > -1.0f && Vector512.LessThanAny(horizon, Vector512.Create(level)))
        {
            (float above, moment) = _disc.LightOver(Vector512.MaxNative(horizon, Vector512.Create(level)));
            return (area, light, ((above * tangent) + (moment * slope)) * cosine);
        }

        return (area, light, ((light * tangent) + (moment * slope)) * cosine);
    }
}
