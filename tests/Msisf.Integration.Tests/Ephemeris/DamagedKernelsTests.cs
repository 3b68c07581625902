using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>Kernels of all types with a flipped bit, or cut off: an error that names the file, or an answer with finite numbers.</summary>
[Collection(SpiceItself.Name)]
public sealed class DamagedKernelsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.CSpice)]
    public void BuiltInReader_FlippedBits_FoundOrHarmless()
    {
        string[] kernels = WriteKernels();
        string[] texts = [_folder["test.tsc"], _folder["test.tf"]];
        Random random = new(20_000);
        int flips = TestLength.Of(600, 20_000);
        int found = 0;
        for (int i = 0; i < flips; i++)
        {
            string path = kernels[i % kernels.Length];
            byte[] bytes = File.ReadAllBytes(path);
            int at = Place(bytes, i, random);
            bytes[at] ^= (byte)(1 << random.Next(8));
            string damaged = _folder.Write("damaged", bytes);
            found += Answers(path, damaged, texts, $"bit flipped in byte {at} of {Path.GetFileName(path)}") ? 0 : 1;
        }

        // Summaries and control words are checked; most bits are data, in which only an exponent shows.
        Assert.InRange(found, flips / 20, flips - (flips / 20));
    }

    [RequiresFact(Part.CSpice)]
    public void BuiltInReader_CutOff_SaysSo()
    {
        string[] kernels = WriteKernels();
        string[] texts = [_folder["test.tsc"], _folder["test.tf"]];
        foreach (string path in kernels.Where(path => !texts.Contains(path)))
        {
            byte[] bytes = File.ReadAllBytes(path);
            foreach (int length in (int[])[0, 7, 500, 1024, 2048, 3072, bytes.Length / 2, bytes.Length - 1024, bytes.Length - 1])
            {
                string damaged = _folder.Write("damaged", bytes[..length]);
                Assert.False(
                    length < bytes.Length - 1024 && Answers(path, damaged, texts, $"{length} bytes of {Path.GetFileName(path)}"),
                    $"{length} bytes of {path} gave an answer");
            }
        }
    }

    /// <summary>One in three in the file record or a summary, one in three near the end, where the sizes stand.</summary>
    private static int Place(byte[] bytes, int i, Random random) => (i % 3) switch
    {
        0 => random.Next(Math.Min(bytes.Length, 1300)),
        1 => Math.Max(0, bytes.Length - 1 - random.Next(1200)),
        _ => random.Next(bytes.Length),
    };

    /// <summary>Asks for states or attitudes; false if the kernel is refused.</summary>
    private static bool Answers(string original, string damaged, string[] texts, string what)
    {
        try
        {
            string[] binary = texts.Contains(original) ? [Path.Combine(Path.GetDirectoryName(original)!, "3.bc")] : [damaged];
            using OpenedEphemeris opened = Engines.BuiltIn(
                [Engines.MetaKernel, .. texts.Select(text => text == original ? damaged : text), .. binary]);
            if (original.EndsWith(".bsp", StringComparison.Ordinal))
            {
                KernelTrajectory trajectory = new(opened, "-999");
                foreach (double time in TimesIn(trajectory.Cover))
                {
                    StateVector state = trajectory.StateJ2000(time);
                    Assert.True(state.Position.IsFinite && state.Velocity.IsFinite, what);
                }
            }
            else
            {
                TdbCover cover = opened.Catalogue.Attitudes.CoverOf(TestClock.Instrument);
                foreach (double time in TimesIn(cover))
                {
                    RotationMatrix matrix = opened.Frames.FrameFromJ2000("TEST_CAMERA", time);
                    Assert.Equal(1.0, matrix.Row0.Length, Rounding.OfPlaces);
                    Assert.Equal(1.0, matrix.Row2.Length, Rounding.OfPlaces);
                }
            }

            return true;
        }
        catch (MsisfException exception)
        {
            Assert.False(string.IsNullOrWhiteSpace(exception.Message), what);
            Assert.DoesNotContain('\n', exception.Message);
            return false;
        }
    }

    private static IEnumerable<double> TimesIn(TdbCover cover) => cover.Intervals.Take(3).SelectMany(
        interval => (double[])[interval.Start, interval.Start + (0.37 * (interval.End - interval.Start)), interval.End]);

    private string[] WriteKernels()
    {
        string sclk = _folder.Write("test.tsc", TestClock.Sclk);
        string frames = _folder.Write("test.tf", TestClock.Frames);
        using OpenedEphemeris loaded = Engines.CSpice(Engines.MetaKernel, sclk, frames);
        List<string> kernels = [sclk, frames];
        foreach (string kind in SpkSamples.Kinds)
        {
            kernels.Add(_folder[$"{kind}.bsp"]);
            SpiceItself.WriteSpk(kernels[^1], handle => SpkSamples.Write(handle, kind));
        }

        foreach (string kind in CkSamples.Kinds)
        {
            kernels.Add(_folder[$"{kind}.bc"]);
            SpiceItself.WriteCk(kernels[^1], handle => CkSamples.Write(handle, kind));
        }

        return [.. kernels];
    }
}
