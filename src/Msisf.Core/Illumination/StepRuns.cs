using System.Numerics;

namespace Msisf.Core.Illumination;

/// <summary>Finds the longest runs of steps with and without light while the steps come by, up to 32 at once.</summary>
/// <param name="nightLimit">Steps: runs without light that are longer are counted.</param>
internal struct StepRuns(double nightLimit)
{
    private int _start;
    private int _steps;
    private bool _isLit;

    /// <summary>The longest run without light.</summary>
    public StepRun Dark { get; private set; }

    /// <summary>The longest run with light.</summary>
    public StepRun Light { get; private set; }

    /// <summary>Runs without light that are longer than the limit.</summary>
    public int Nights { get; private set; }

    /// <summary>Adds steps.</summary>
    /// <param name="lit">Whether each is lit, the first in the lowest bit.</param>
    /// <param name="count">How many, 1 to 16.</param>
    public void Add(uint lit, int count)
    {
        for (int left = count; left > 0;)
        {
            bool isLit = (lit & 1) != 0;
            if (isLit != _isLit)
            {
                End();
                (_isLit, _start) = (isLit, _steps);
            }

            int run = Math.Min(left, BitOperations.TrailingZeroCount(isLit ? ~lit : lit | 0x8000_0000));
            (lit, left, _steps) = (lit >> run, left - run, _steps + run);
        }
    }

    /// <summary>Ends the last run.</summary>
    public void End()
    {
        StepRun run = new(_start, _steps - _start);
        if (_isLit)
        {
            Light = run.Count > Light.Count ? run : Light;
            return;
        }

        Dark = run.Count > Dark.Count ? run : Dark;
        Nights += run.Count > nightLimit ? 1 : 0;
    }
}
