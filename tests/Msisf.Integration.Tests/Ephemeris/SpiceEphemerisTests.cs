using System.Globalization;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

public sealed class SpiceEphemerisTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("msis cspice ä ");

    public void Dispose() => _folder.Delete(recursive: true);

    [RequiresFact(Part.CSpice)]
    public void SunPositionMoonMe_ExampleOfTheThesis_HasItsDigits()
    {
        using OpenedEphemeris opened = Engines.CSpice();

        Vector3D sun = opened.Engine.SunPositionBodyFixed(Moments.OfMjd(55289.0));

        // Thesis section 9.2: printed with 15 digits and a zero.
        Assert.Equal("1.07495547328088E+011", sun.X.ToString("E14", CultureInfo.InvariantCulture)); // m: the number has 15 digits
        Assert.Equal("-1.04243073487898E+011", sun.Y.ToString("E14", CultureInfo.InvariantCulture));
        Assert.Equal("4.03616430556126E+009", sun.Z.ToString("E14", CultureInfo.InvariantCulture));
        Assert.Equal("CSPICE N0067", opened.Engine.EngineName);
        Assert.StartsWith("Ephemeris: CSPICE N0067 (", opened.Notice, StringComparison.Ordinal);
    }

    [RequiresFact(Part.CSpice)]
    public void Open_Auto_TakesCSpice()
    {
        using OpenedEphemeris opened = Engines.Open(EphemerisChoice.Auto);

        Assert.Equal("CSPICE N0067", opened.Engine.EngineName);
    }

    [RequiresFact(Part.CSpice)]
    public void SunPositionMoonMe_PartOfASecondLater_IsNotCutOff()
    {
        using OpenedEphemeris opened = Engines.CSpice();
        Vector3D whole = opened.Engine.SunPositionBodyFixed(Moments.OfMjd(55289.0));
        Vector3D later = opened.Engine.SunPositionBodyFixed(Moments.OfMjd(55289.0 + (0.999 / 86400.0)));

        // tests/reference/ephemeris.py, CSPICE N0067, utc2et_c with .999: 367 708 m and 0.140647 mdeg. A microsecond is 0.4 m.
        Assert.Equal(367_708.0, (later - whole).Length, 1.0);
        Assert.Equal(0.140647e-3, Vector3D.AngleBetween(later, whole) * 180.0 / Math.PI, Rounding.OfPlaces);
    }

    [RequiresTheory(Part.CSpice)]
    [InlineData(15019.999, "1899-12-31T23:58:33.6Z (MJD 15019.999)")]
    [InlineData(70172.0, "2051-01-01T00:00:00Z (MJD 70172)")]
    public void Ask_OutsideTheKernels_NamesTheCoverAndKeepsSpicesText(double mjd, string time)
    {
        using OpenedEphemeris opened = Engines.CSpice();

        SpiceException sun = Assert.Throws<SpiceException>(() => opened.Engine.SunPositionBodyFixed(Moments.OfMjd(mjd)));
        SpiceException frame = Assert.Throws<SpiceException>(() => opened.Engine.BodyFromJ2000(Moments.OfMjd(mjd).Tdb));

        Assert.All([sun, frame], failure =>
        {
            Assert.StartsWith(time, failure.Message, StringComparison.Ordinal);
            Assert.Contains("the kernels cover 1899-12-31T23:59:19Z to 2050-12-31T23:58:50Z", failure.Message, StringComparison.Ordinal);
            Assert.Contains("SPICE(", failure.InnerException!.Message, StringComparison.Ordinal);
        });
        Assert.True(opened.Engine.SunPositionBodyFixed(Moments.OfMjd(55289.0)).IsFinite);
    }

    [RequiresFact(Part.CSpice)]
    public void SunPositionMoonMe_NoSunInTheKernels_GivesSpicesTexts()
    {
        using OpenedEphemeris opened = Engines.CSpice(Path.Combine(TestParts.Kernels, "naif0012.tls"));

        SpiceException failure = Assert.Throws<SpiceException>(() => opened.Engine.SunPositionBodyFixed(Moments.OfMjd(55289.0)));

        Assert.StartsWith("CSPICE failed in spkpos_c (323524866.18", failure.Message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.CSpice)]
    public void Open_DamagedKernel_GivesSpicesTextsAndTheNextOpenWorks()
    {
        string damaged = Path.Combine(_folder.FullName, "damaged.tls");
        File.WriteAllText(damaged, "KPL/LSK\n\\begindata\nDELTET/EB = five\n\\begintext\n");

        SpiceException failure = Assert.Throws<SpiceException>(() => Engines.CSpice(Engines.MetaKernel, damaged));

        Assert.StartsWith($"CSPICE failed in furnsh_c ({damaged}): SPICE(", failure.Message, StringComparison.Ordinal);
        using OpenedEphemeris opened = Engines.CSpice();
        Assert.True(opened.Engine.SunPositionBodyFixed(Moments.OfMjd(55289.0)).IsFinite);
    }

    [RequiresTheory(Part.CSpice)]
    [InlineData(255, true)]
    [InlineData(256, false)]
    public void Open_LongPath_WorksUpTo255Bytes(int bytes, bool works)
    {
        string name = Path.Combine(_folder.FullName, new string('d', 100));
        Directory.CreateDirectory(name);
        int taken = System.Text.Encoding.UTF8.GetByteCount(name) + 1;
        string path = Path.Combine(name, new string('k', bytes - taken - 4) + ".bpc");
        File.Copy(Path.Combine(TestParts.Kernels, "moon_pa_de421_1900-2050.bpc"), path);

        Exception? failure = Record.Exception(() => Engines.CSpice(path).Dispose());

        Assert.Equal(
            works
                ? null
                : $"{path}: the path has 256 bytes; CSPICE takes 255 at most. "
                    + $"Move the kernels to a shorter path, or use --ephemeris builtin.",
            failure?.Message);
    }

    [RequiresFact(Part.CSpice)]
    public void SunPositionMoonMe_TwoEnginesWithOtherKernels_DoNotMix()
    {
        // One leap second more at 2010-01-01: the Sun of 2010-04-03 is where it was a second later.
        string later = Path.Combine(_folder.FullName, "later.tls");
        File.WriteAllText(later, "KPL/LSK\n\\begindata\nDELTET/DELTA_AT = ( 35, @2010-JAN-1 )\n\\begintext\n");
        using OpenedEphemeris first = Engines.CSpice();
        using OpenedEphemeris second = Engines.CSpice(Engines.MetaKernel, later);
        Instant time = first.Engine.TimeScale.InstantOfMjd(55289.0);

        Vector3D before = first.Engine.SunPositionBodyFixed(time);
        Vector3D other = second.Engine.SunPositionBodyFixed(second.Engine.TimeScale.InstantOfMjd(55289.0));
        Vector3D after = first.Engine.SunPositionBodyFixed(time);

        Assert.Equal(before, after);
        Assert.Equal(368_076.0, (other - before).Length, 10.0);
    }

    [RequiresFact(Part.CSpice)]
    public void SunPositionMoonMe_FromAnotherWorkingDirectoryAndPathWithBlanks_Works()
    {
        foreach (string kernel in KernelList.Expand([Engines.MetaKernel]))
        {
            File.CreateSymbolicLink(Path.Combine(_folder.FullName, Path.GetFileName(kernel)), kernel);
        }

        string meta = Path.Combine(_folder.FullName, "my list.tm");
        File.Copy(Engines.MetaKernel, meta);
        using OpenedEphemeris opened = Engines.CSpice(meta);

        // m: the number has 15 digits
        Assert.Equal(1.07495547328088E+011, opened.Engine.SunPositionBodyFixed(Moments.OfMjd(55289.0)).X, 1e-3);
    }

    [RequiresFact(Part.CSpice)]
    public void SunPositionMoonMe_ManyThreads_GiveTheSameBitsAsOne()
    {
        using OpenedEphemeris opened = Engines.CSpice();
        double[] times = [.. Enumerable.Range(0, 1000).Select(i => 15021.0 + (i * 55.0))];
        Vector3D[] expected = [.. times.Select(time => opened.Engine.SunPositionBodyFixed(Moments.OfMjd(time)))];
        Vector3D[] found = new Vector3D[times.Length];

        Parallel.For(0, times.Length, new ParallelOptions { MaxDegreeOfParallelism = 8 }, i =>
            found[i] = opened.Engine.SunPositionBodyFixed(Moments.OfMjd(times[i])));

        Assert.Equal(expected, found);
    }
}
