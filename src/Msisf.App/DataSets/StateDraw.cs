using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Preview;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.App.DataSets;

/// <summary>
/// Draws the states of a data set: point after point of the unit cube, until as many states meet the conditions as the data set needs.
/// </summary>
/// <param name="spec">What the data set asks for.</param>
/// <param name="scene">Terrain.</param>
/// <param name="ephemeris">Not used where each state has its Sun.</param>
/// <param name="probe">Tells what an image will show.</param>
internal sealed class StateDraw(
    DataSetSpec spec, RenderSettings settings, ISceneGeometry scene, Func<IEphemeris> ephemeris, ViewProbe probe)
{
    /// <summary>So many states in a row that meet no condition are enough to give up.</summary>
    private const int MostInVain = 2000;

    /// <summary>States that are looked at side by side at most; which ones are taken does not depend on it.</summary>
    private const int Block = 64;

    private const string InTheGround = "above the ground";
    private const string GroundShare = "ground";
    private const string LitShare = "lit";
    private const string SunElevation = "sun-elevation";
    private const string OneRegion = "one region";

    private readonly StateMaker _maker = new(spec, scene);

    /// <param name="progress">Receives a step for each image.</param>
    /// <exception cref="BadInputException">No state meets the conditions.</exception>
    public DrawnStates Run(IRunProgress progress, CancellationToken cancellation)
    {
        List<DrawnState[]>[] taken = [.. spec.Splits.Select(_ => new List<DrawnState[]>())];
        List<SplitDraw> draws = [];
        for (int index = 0; index < spec.Splits.Count; index++)
        {
            Split split = spec.Splits[index];
            UnitCubePoints points = new(Quantity.Coordinates, spec.IsEven, spec.Seed, index);
            SortedDictionary<string, int> rejected = new(StringComparer.Ordinal);
            int found = 0;
            int inVain = 0;
            long candidate = 0;
            while (found < split.Count)
            {
                foreach ((DrawnState[] states, string? failed) in Looked(
                    split, points, candidate, Math.Min(Block, split.Count - found), cancellation))
                {
                    candidate++;
                    if (failed is null)
                    {
                        taken[index].Add(states);
                        progress.Advance(split.Name);
                        (found, inVain) = (found + 1, 0);
                    }
                    else
                    {
                        rejected[failed] = rejected.GetValueOrDefault(failed) + 1;
                        inVain++;
                    }

                    if (found == split.Count || inVain == MostInVain)
                    {
                        break;
                    }
                }

                if (inVain == MostInVain)
                {
                    throw new BadInputException(
                        $"{spec.Path}: of '{split.Name}' {found} of {split.Count} images were found, and the last {MostInVain} states "
                            + $"met not all conditions ({Listed(rejected)} of {candidate} failed). Loosen the "
                            + "conditions, or change the states.");
                }
            }

            draws.Add(new SplitDraw(split, candidate, rejected));
        }

        // Both images of a pair are side by side; each has a step of the noise.
        int[] next = new int[taken.Length];
        return new DrawnStates([.. spec.Order.SelectMany(split => taken[split][next[split]++]).Select(WithNoise)], draws);
    }

    private DrawnState WithNoise(DrawnState drawn, int index) => settings.Native.Detector is null ? drawn
        : drawn with { State = drawn.State with { Noise = new NoiseSeed(spec.NoiseSeed, (ulong)index + 1) } };

    private static string Listed(SortedDictionary<string, int> rejected) =>
        string.Join(", ", rejected.Select(entry => Invariant($"'{entry.Key}' {entry.Value}")));

    /// <summary>The states of the next points, each with the condition that it does not meet.</summary>
    private (DrawnState[] States, string? Failed)[] Looked(
        Split split, UnitCubePoints points, long first, int count, CancellationToken cancellation)
    {
        DrawnState[][] drawn = [.. Enumerable.Range(0, count)
            .Select(index => _maker.Of(split, first + index, points.PointAt(first + index)))];

        // CSPICE is not thread-safe, so that all lights come first.
        Frame[][] frames = [.. drawn.Select(states => FrameSetup.Of(
            [.. states.Select(state => state.State)], [.. states.Select(_ => split.Name)], settings with { Frames = null },
            new SunPositions(ephemeris, settings.Aberration),
            cancellation))];
        (DrawnState[] States, string? Failed)[] looked = new (DrawnState[], string?)[count];
        ParallelOptions sideBySide = new()
        {
            CancellationToken = cancellation,
            MaxDegreeOfParallelism = ResourceCheck.AtOnce(
                settings, count, Environment.ProcessorCount, GC.GetGCMemoryInfo().TotalAvailableMemoryBytes),
        };
        Parallel.For(0, count, sideBySide, index =>
        {
            DrawnState[] states = drawn[index];
            string? failed = null;
            for (int i = 0; i < states.Length && failed is null; i++)
            {
                (states[i], failed) = Look(states[i], frames[index][i], split, cancellation);
            }

            looked[index] = (states, failed);
        });
        return looked;
    }

    private (DrawnState State, string? Failed) Look(DrawnState drawn, Frame frame, Split split, CancellationToken cancellation)
    {
        Vector3D position = drawn.State.PositionBodyFixed;
        double ground = scene.GroundRadius(position);
        if (position.Length < ground + Quantity.Altitude.Least)
        {
            return (drawn, InTheGround);
        }

        SkyDirection sun = SkyDirection.Of(ground * position.Normalized(), frame.Light.PositionBodyFixed);
        Conditions accept = spec.Accept;
        if (accept.SunElevation is { } range)
        {
            double degrees = double.RadiansToDegrees(sun.Elevation);
            if (!(degrees >= range.Min && degrees <= range.Max))
            {
                return (drawn, SunElevation);
            }
        }

        View view = probe.Of(frame, cancellation);
        drawn = drawn with { Ground = view.Ground, Lit = view.Lit, Sun = sun };
        return (drawn, view.Ground < accept.Ground ? GroundShare
            : view.Lit < accept.Lit ? LitShare
            : split.IsBound && !(view.Points.All(drawn.Region.Contains) && probe.ShowsOnly(frame, drawn.Region, cancellation)) ? OneRegion
            : null);
    }
}

/// <summary>The states of a data set.</summary>
/// <param name="States">States of all images, in their order; those of a pair are side by side.</param>
/// <param name="Splits">How each split was drawn.</param>
internal sealed record DrawnStates(IReadOnlyList<DrawnState> States, IReadOnlyList<SplitDraw> Splits);

/// <summary>How a split was drawn.</summary>
/// <param name="Candidates">How many states were looked at.</param>
/// <param name="Rejected">How many of them did not meet a condition, by the first that failed.</param>
internal sealed record SplitDraw(Split Split, long Candidates, IReadOnlyDictionary<string, int> Rejected);

/// <summary>The state of one image of a data set, and what was drawn for it.</summary>
/// <param name="Split">Name of its split.</param>
/// <param name="Candidate">Number of the point of the unit cube that it comes from, from 0 in each split.</param>
/// <param name="Region">The region that its place was drawn in.</param>
/// <param name="Drawn">The drawn numbers; both images of a pair have the same.</param>
internal sealed record DrawnState(
    string Split, long Candidate, Region Region, IReadOnlyDictionary<Quantity, double> Drawn, SpacecraftState State)
{
    /// <summary>The part of the image that shows ground.</summary>
    public double Ground { get; init; }

    /// <summary>The part of that ground that gets light.</summary>
    public double Lit { get; init; }

    /// <summary>Where the Sun is over the ground below the camera.</summary>
    public SkyDirection Sun { get; init; }

    /// <summary>The point below the camera.</summary>
    public SelenographicPoint Place => SelenographicPoint.Below(State.PositionBodyFixed);
}
