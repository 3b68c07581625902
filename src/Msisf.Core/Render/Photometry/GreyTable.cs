using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Converts whole rows of radiance factors to levels by a table, which avoids a power function for each pixel. The levels are those of
/// <see cref="GreyScale.Level"/>, except for radiance factors within 1e-14 (relative) of the border between two levels. Safe for several
/// threads.
/// </summary>
public sealed class GreyTable
{
    /// <summary>
    /// Number of steps of the table for each level. The sRGB curve is nowhere steeper than 12.92, so a level is at least 1 / 12.92 of full
    /// scale over the number of levels wide. 16 steps per level are narrower than that, so no two borders share a step.
    /// </summary>
    private const int StepsPerLevel = 16;

    /// <summary>Bits behind the point of a step: 4096 steps of 8 bits fill an int with its sign.</summary>
    private const int FractionBits = 18;

    private const int FractionMask = (1 << FractionBits) - 1;

    private readonly int _maxLevel;
    private readonly double _stepsPerRadianceFactor;
    private readonly double _lastStep;
    private readonly ushort[] _levelBeforeStep;
    private readonly double[] _min;

    /// <summary>For 8 bits of each step: the level before it, and in the last bits where in it the next border lies.</summary>
    private readonly int[] _stepsOfBytes;

    /// <summary>Computes the table. For 8 bits this takes some microseconds and 10 kB, for 16 bits some milliseconds and 2.6 MB.</summary>
    /// <param name="bitDepth">Bits of a level: 8 or 16.</param>
    public GreyTable(GreyScale scale, int bitDepth)
    {
        Debug.Assert(bitDepth is 8 or 16, "PNG's depths of a grey image that is shown");
        BitDepth = bitDepth;
        _maxLevel = (1 << bitDepth) - 1;
        _lastStep = (1 << bitDepth) * StepsPerLevel;
        _stepsPerRadianceFactor = scale.Exposure * _lastStep;
        _min = new double[_maxLevel + 2];
        _min[_maxLevel + 1] = double.NaN; // nothing passes it, not even infinity
        for (int level = 1; level <= _maxLevel; level++)
        {
            _min[level] = scale.MinRadianceFactor(level, _maxLevel);
        }

        _levelBeforeStep = new ushort[(int)_lastStep + 1];
        int reached = 0;
        for (int step = 0; step < _levelBeforeStep.Length; step++)
        {
            _levelBeforeStep[step] = (ushort)reached;
            if (reached < _maxLevel && StepOf(_min[reached + 1]) == step)
            {
                reached++;
            }
        }

        _stepsOfBytes = bitDepth == 8
            ? [.. _levelBeforeStep.Select((level, step) => (level << FractionBits) | FractionOf(_min[level + 1], step))]
            : [];
    }

    /// <summary>Bits of a level: 8 or 16.</summary>
    public int BitDepth { get; }

    /// <summary>Converts radiance factors to levels of 8 bits.</summary>
    /// <param name="radianceFactors">I/F, not NaN.</param>
    /// <param name="levels">Receives as many levels.</param>
    public void Convert(ReadOnlySpan<double> radianceFactors, Span<byte> levels)
    {
        Debug.Assert(BitDepth == 8, "the table is for 8 bits");
        levels = levels[..radianceFactors.Length];
        Steps steps = new(this);
        for (int i = Avx.IsSupported ? ConvertEights(radianceFactors, levels) : 0; i < levels.Length; i++)
        {
            levels[i] = (byte)steps.LevelOf(radianceFactors[i]);
        }
    }

    /// <summary>Converts radiance factors to levels of 16 bits.</summary>
    /// <param name="radianceFactors">I/F, not NaN.</param>
    /// <param name="levels">Receives as many levels.</param>
    public void Convert(ReadOnlySpan<double> radianceFactors, Span<ushort> levels)
    {
        Debug.Assert(BitDepth == 16, "the table is for 16 bits");
        levels = levels[..radianceFactors.Length];
        Steps steps = new(this);
        for (int i = 0; i < levels.Length; i++)
        {
            levels[i] = (ushort)steps.LevelOf(radianceFactors[i]);
        }
    }

    /// <summary>
    /// Converts eight at once, which takes two thirds of the time. Steps are counted with a fraction: where that is another one than the
    /// border's, it says on which side of the border the radiance factor lies; where it is the same, the numbers themselves are compared.
    /// </summary>
    /// <returns>How many are converted; fewer than eight are left.</returns>
    private int ConvertEights(ReadOnlySpan<double> radianceFactors, Span<byte> levels)
    {
        ref int table = ref MemoryMarshal.GetArrayDataReference(_stepsOfBytes);
        Vector256<double> scale = Vector256.Create(_stepsPerRadianceFactor * (1 << FractionBits));
        Vector256<double> last = Vector256.Create(_lastStep * (1 << FractionBits));
        Vector256<int> mask = Vector256.Create(FractionMask);
        Steps steps = new(this);
        int i = 0;
        for (; i <= levels.Length - 8; i += 8)
        {
            Vector256<int> place = Vector256.Create(
                Places(ArrayLanes.Load256(radianceFactors, i)), Places(ArrayLanes.Load256(radianceFactors, i + 4)));
            Vector256<int> step = Vector256.ShiftRightArithmetic(place, FractionBits);
            Debug.Assert(
                Vector256.LessThanAll(step.AsUInt32(), Vector256.Create((uint)_stepsOfBytes.Length)), "A step lies outside the table.");
            Vector256<int> found = Vector256.Create(
                Unsafe.Add(ref table, step[0]), Unsafe.Add(ref table, step[1]), Unsafe.Add(ref table, step[2]),
                Unsafe.Add(ref table, step[3]), Unsafe.Add(ref table, step[4]), Unsafe.Add(ref table, step[5]),
                Unsafe.Add(ref table, step[6]), Unsafe.Add(ref table, step[7]));
            Vector256<int> level = Vector256.ShiftRightArithmetic(found, FractionBits)
                - Vector256.GreaterThan(place & mask, found & mask);
            Vector128<ushort> words = Vector128.Narrow(level.GetLower(), level.GetUpper()).AsUInt16();
            Vector128.Narrow(words, words).GetLower().CopyTo(levels[i..]);
            if (Vector256.EqualsAny(place & mask, found & mask))
            {
                for (int j = i; j < i + 8; j++)
                {
                    levels[j] = (byte)steps.LevelOf(radianceFactors[j]);
                }
            }
        }

        return i;

        Vector128<int> Places(Vector256<double> factors) => Avx.ConvertToVector128Int32WithTruncation(
            Vector256.MinNative(Vector256.MaxNative(factors * scale, Vector256<double>.Zero), last));
    }

    /// <summary>Where in its step a border lies; the end of the step for one that is in a later step, or in none.</summary>
    private int FractionOf(double border, int step)
    {
        double place = border * _stepsPerRadianceFactor * (1 << FractionBits);
        return place < (step + 1.0) * (1 << FractionBits) ? (int)place & FractionMask : FractionMask;
    }

    private int StepOf(double radianceFactor) => new Steps(this).StepOf(radianceFactor);

    /// <summary>The table on the stack: the compiler would read the fields of the object again for each pixel.</summary>
    private readonly ref struct Steps(GreyTable table)
    {
        private readonly ReadOnlySpan<ushort> _levelBeforeStep = table._levelBeforeStep;
        private readonly ReadOnlySpan<double> _min = table._min;
        private readonly double _stepsPerRadianceFactor = table._stepsPerRadianceFactor;
        private readonly double _lastStep = table._lastStep;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int LevelOf(double radianceFactor)
        {
            // The step never decreases as the radiance factor grows, so the borders of all earlier steps are passed. The step itself holds
            // at most one border.
            int level = _levelBeforeStep[StepOf(radianceFactor)];
            return level + (radianceFactor >= _min[level + 1] ? 1 : 0);
        }

        // The native forms are one instruction each. They differ from the others only for NaN and for values that are clamped before the
        // conversion.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int StepOf(double radianceFactor) => double.ConvertToIntegerNative<int>(
            double.MinNative(double.MaxNative(radianceFactor * _stepsPerRadianceFactor, 0.0), _lastStep));
    }
}
