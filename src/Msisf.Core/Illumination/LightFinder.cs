using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Ephemeris;

namespace Msisf.Core.Illumination;

/// <summary>Compares horizons with the Sun's and the Earth's paths, sixteen steps at a time. Each thread has its own.</summary>
internal sealed class LightFinder
{
    private const int Lanes = LightTimes.Lanes;

    private const int Strips = 16;

    /// <summary>W/m^2 at one astronomical unit.</summary>
    private const double FluxAtAu = 1361.0;

    /// <summary>Part of a disc that is reported for a sliver which rays see, but no strip.</summary>
    private const float LeastPart = 1e-6f;

    private readonly DiscOfLight _sunDisc = new(Strips, isDarkened: true);
    private readonly DiscOfLight _fineDisc = new(4 * Strips, isDarkened: false);
    private readonly DiscOfLight _earthDisc = new(Strips, isDarkened: false);
    private readonly LightTimes _sun;
    private readonly SkySteps _sunSteps;
    private readonly SkySteps _earthSteps;
    private readonly uint[] _sunSeen;
    private readonly uint[] _earthSeen;
    private readonly float[] _flux;
    private readonly Vector3D _fixedLocal;
    private readonly double _nightLimit;

    /// <summary>Prepares an interval.</summary>
    /// <param name="sun">The Sun's path.</param>
    /// <param name="earth">The Earth's.</param>
    /// <param name="conditions">What is asked for.</param>
    /// <param name="steepest">Tangent of the greatest elevation of a horizon.</param>
    public LightFinder(LightTimes sun, LightTimes earth, LightConditions conditions, double steepest)
    {
        const double Au = AstronomicalConstants.AstronomicalUnit;
        (_sun, _fixedLocal, _nightLimit) = (sun, conditions.FixedPlane, conditions.NightLimit);
        _flux = [.. sun.Distances.Select(distance => (float)(FluxAtAu * Au * Au / (distance * distance)))];
        Table = new HorizonTable(HorizonSurvey.Columns);
        _sunSteps = new SkySteps(sun, HorizonSurvey.Columns, steepest);
        _earthSteps = new SkySteps(earth, HorizonSurvey.Columns, steepest);
        (_sunSeen, _earthSeen) = (new uint[_sunSteps.Whole.Length], new uint[_earthSteps.Whole.Length]);
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
        _sunSteps.Path.Forget();
        _earthSteps.Path.Forget();
    }

    /// <summary>The light of a place whose horizon is in <see cref="Table"/>.</summary>
    /// <param name="rays">From the place.</param>
    public PlaceLight Of(PlaceRays rays)
    {
        LocalFrame frame = rays.Frame;
        Table.FindLimits();
        _sunSteps.Find(Table, frame);
        _earthSteps.Find(Table, frame);
        LightSums sums = default;
        SeeSun(rays, ref sums);
        int wholeEarth = SeeEarth();
        StepRuns runs = new(_nightLimit);
        (int lit, int earth, int both) = (0, 0, 0);
        for (int block = 0; block < _sunSeen.Length; block++)
        {
            (uint sunSeen, uint earthSeen) = (_sunSeen[block], _earthSeen[block]);
            runs.Add(sunSeen, Math.Min(Lanes, _sun.Count - (block * Lanes)));
            lit += BitOperations.PopCount(sunSeen);
            earth += BitOperations.PopCount(earthSeen);
            both += BitOperations.PopCount(sunSeen & earthSeen);
        }

        runs.End();
        return sums.ToLight(_sun.Count) with
        {
            LitSteps = lit,
            Dark = runs.Dark,
            Light = runs.Light,
            Nights = runs.Nights,
            EarthSteps = earth,
            WholeEarthSteps = wholeEarth,
            BothSteps = both,
        };
    }

    /// <summary>Finds the steps at which any of the Sun is in view, and sums up its light.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void SeeSun(PlaceRays rays, ref LightSums sums)
    {
        LocalFrame frame = rays.Frame;
        Vector3D upright = _sunSteps.Path.ToLocal(frame.Up);
        Vector3D plane = _sunSteps.Path.ToLocal(
            (_fixedLocal.X * frame.East) + (_fixedLocal.Y * frame.North) + (_fixedLocal.Z * frame.Up));
        Vector512<float> zero = Vector512<float>.Zero;
        Parts?.AsSpan().Clear();
        for (int block = 0; block < _sunSeen.Length; block++)
        {
            uint whole = _sunSteps.Whole[block];
            _sunSeen[block] = whole;
            if (whole != 0)
            {
                int step = block * Lanes;
                Vector512<float> area = LaneMasks.Of(whole) & Vector512<float>.One;
                Vector512<float> light = area * ArrayLanes.Load(_flux, step);
                Vector512<float> up = _sunDisc.UpOf(_sunSteps.Path.CosineTo(upright, step), ArrayLanes.Load(_sun.Slope, step));
                sums.Add(area, light, light * up, light * Vector512.MaxNative(zero, _sunSteps.Path.CosineTo(plane, step)));
                if (Parts is { } parts)
                {
                    area.StoreTo(parts, step);
                }
            }
        }

        for (int first = 0; first < _sunSteps.NearCount; first += Lanes)
        {
            (DiscParts parts, uint visible) = SeeNearSun(rays, first);
            Vector512<int> steps = _sunSteps.StepsAt(first);
            Vector512<float> isVisible = LaneMasks.Of(visible);
            Vector512<float> flux = HorizonTable.Gather(_flux, steps) & isVisible;
            Vector512<float> light = parts.Light * flux;
            Vector512<float> onPlane = Vector512.MaxNative(zero, _sunSteps.Path.CosineTo(plane, steps));
            sums.Add(parts.Area & isVisible, light, parts.Up * flux, light * onPlane);
            for (uint left = visible; left != 0; left &= left - 1)
            {
                int lane = BitOperations.TrailingZeroCount(left);
                int step = _sunSteps.Near[first + lane];
                _sunSeen[step / Lanes] |= 1u << (step % Lanes);
                if (Parts is not null)
                {
                    Parts[step] = Math.Max(parts.Area[lane], LeastPart);
                }
            }
        }
    }

    /// <summary>Finds the steps at which any of the Earth is in view.</summary>
    /// <returns>At how many all of it is.</returns>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private int SeeEarth()
    {
        int count = 0;
        for (int block = 0; block < _earthSeen.Length; block++)
        {
            _earthSeen[block] = _earthSteps.Whole[block];
            count += BitOperations.PopCount(_earthSteps.Whole[block]);
        }

        for (int first = 0; first < _earthSteps.NearCount; first += Lanes)
        {
            uint valid = ValidFrom(first, _earthSteps.NearCount);
            (uint whole, uint any) = _earthDisc.SeeOver(Table, _earthSteps.NearAt(first));
            count += BitOperations.PopCount(whole & valid);
            for (any &= valid; any != 0; any &= any - 1)
            {
                int step = _earthSteps.Near[first + BitOperations.TrailingZeroCount(any)];
                _earthSeen[step / Lanes] |= 1u << (step % Lanes);
            }
        }

        return count;
    }

    /// <summary>The parts of the Sun that are over the horizon at sixteen steps at which that is near, and the steps with any.</summary>
    private (DiscParts Parts, uint Visible) SeeNearSun(PlaceRays rays, int first)
    {
        SeenBody sun = _sunSteps.NearAt(first);
        DiscParts parts;
        uint visible;
        Vector512<float> toHorizon; // rad: if it is small, the horizon's error leaves open whether any of the Sun is in view
        if (_sun.MaxSlope == 0.0f)
        {
            Vector512<float> one = Vector512<float>.One;
            Vector512<float> over = sun.Tangent - Table.At(sun.Column);
            parts = new DiscParts(one, one, Vector512.MaxNative(Vector512<float>.Zero, sun.Tangent / sun.PerCosine));
            visible = LanesAbove(over, 0.0f);
            toHorizon = Vector512.Abs(over) / (sun.PerCosine * sun.PerCosine);
        }
        else
        {
            parts = _sunDisc.Over(Table, sun);
            parts = Parts is null ? parts : parts with { Area = _fineDisc.AreaOver(Table, sun) };
            visible = LanesAbove(parts.Area, 0.0f);
            toHorizon = 0.5f * parts.Area * sun.Slope;
        }

        uint valid = ValidFrom(first, _sunSteps.NearCount);
        uint doubtful = Exact is null ? 0 : ~LanesAbove(toHorizon, ExactLight.Doubt) & valid;
        for (uint left = doubtful; left != 0; left &= left - 1)
        {
            int lane = BitOperations.TrailingZeroCount(left);
            visible &= ~(1u << lane);
            visible |= Exact!.IsVisible(rays, Table.Tangents, _sunSteps.Near[first + lane]) ? 1u << lane : 0;
        }

        return (parts, visible & valid);
    }

    /// <summary>The lanes, of sixteen from one on, that are before an end.</summary>
    private static uint ValidFrom(int first, int end) => (1u << Math.Min(Lanes, end - first)) - 1;

    private static uint LanesAbove(Vector512<float> values, float limit) =>
        (uint)Vector512.GreaterThan(values, Vector512.Create(limit)).ExtractMostSignificantBits();
}
