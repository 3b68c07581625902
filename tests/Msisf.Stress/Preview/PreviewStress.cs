namespace Msisf.Stress.Preview;

/// <summary>What <c>--dry-run</c> tells of an image: how much of it shows the Moon, and how much of that is lit.</summary>
public sealed class PreviewStress : IStressTest
{
    /// <inheritdoc/>
    public string Name => "preview";

    /// <inheritdoc/>
    public string Subject =>
        "Cameras of all kinds (as in the test of cameras), turned about a line of sight that passes the Moon from its centre to a hundred "
            + "radii beside it, a quarter of them within a millionth of the limb: the share of the image that shows the sphere, and the "
            + "lit share, against the angle between the sphere and the pyramid of the image, and against rays.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int cases = length == StressLength.Full ? 200_000 : 4_000;
        PreviewMeasure measure = SeededCases.Run(cases, seed, () => new PreviewMeasure());
        return new StressReport(Name, cases, [.. measure.Figures], []);
    }
}
