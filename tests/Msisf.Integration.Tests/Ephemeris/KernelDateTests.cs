using Msisf.Adapters.Ephemeris;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>Dates behind @ in text kernels, as CSPICE reads them.</summary>
[Collection(SpiceItself.Name)]
public sealed class KernelDateTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private static readonly string[] Months = ["JAN", "Feb", "MARCH", "apr", "MAY", "June", "JUL", "AUG", "SEPT", "Oct", "NOV", "DECEMBER"];

    public void Dispose() => _folder.Dispose();

    /// <summary>Forms that kernels in use have, and their siblings; each is loaded by CSPICE.</summary>
    [RequiresTheory(Part.CSpice)]
    [InlineData("1972-JAN-1")]
    [InlineData("1972-JAN-1-12:00:00")]
    [InlineData("2009-06-10T12:57:27.4670")] // Kaguya
    [InlineData("2009-06-10T12:57Z")]
    [InlineData("2019-08-27/20:15:11.10")] // LRO
    [InlineData("28-OCT-1994")] // Galileo
    [InlineData("28-OCT-1994-12:00")]
    [InlineData("28OCT1994")]
    [InlineData("OCT-28-1994/12:00:01.5")]
    [InlineData("1994-301//12:00")]
    [InlineData("301-1994//12:00:30.25")]
    [InlineData("1994-301T12:00:00")]
    [InlineData("1994-301T")]
    [InlineData("1994-301::06:30")]
    [InlineData("1994-10-28T12")]
    [InlineData("10/28/1994")]
    [InlineData("10/28/94")]
    [InlineData("10-28-1994-06:30")]
    [InlineData("1994/10/28/12:00")]
    [InlineData("12:00:00.5-28-OCT-1994")]
    [InlineData("1994-OCT-28:12:00:00")]
    [InlineData("TUE28-OCT-1994")]
    [InlineData("28-OCT-50B.C.")]
    [InlineData("1994AD-OCT-28")]
    [InlineData("2449653.5JD")]
    [InlineData("JD2449653.75")]
    [InlineData("1994-OCT-28-24:00")]
    [InlineData("1994-FEB-30")]
    public void Date_FormThatCSpiceLoads_HasItsValue(string date)
    {
        using OpenedEphemeris started = Engines.CSpice();
        Assert.NotNull(started.Engine.EngineName);
        string kernel = _folder.Write("dates.tsc", $"KPL/SCLK\n\\begindata\nDATES_OF_TEST = ( @{date}, @2000-JAN-01 )\n\\begintext\n");
        double[] expected = new double[2];
        SpiceItself.furnsh_c(SpiceItself.Bytes(kernel));
        SpiceItself.ThrowIfFailed();
        SpiceItself.gdpool_c(SpiceItself.Bytes("DATES_OF_TEST"), 0, 2, out int count, expected, out int isFound);
        SpiceItself.unload_c(SpiceItself.Bytes(kernel));
        SpiceItself.ThrowIfFailed();
        Assert.Equal((2, 1), (count, isFound));

        Assert.Equal(expected, KernelPool.Of([kernel]).Numbers("DATES_OF_TEST", 2));
    }

    /// <summary>Dates in random orders with random separators: CSPICE and the reader take the same ones, for the same times.</summary>
    [RequiresFact(Part.CSpice)]
    public void Date_Random_IsReadAsByCSpice()
    {
        using OpenedEphemeris started = Engines.CSpice();
        Assert.NotNull(started.Engine.EngineName);
        Random random = new(41);
        int taken = 0;
        int count = TestLength.Of(10_000, 1_000_000);
        for (int i = 0; i < count; i++)
        {
            string date = RandomDate(random);
            byte[] error = new byte[400];
            SpiceItself.tparse_c(SpiceItself.Bytes(date), error.Length, out double expected, error);
            SpiceItself.ThrowIfFailed();

            bool isTaken = KernelDate.TryParse(date, out double actual);

            Assert.True(isTaken == (error[0] == 0), $"{date}: {System.Text.Encoding.ASCII.GetString(error).TrimEnd('\0')}");
            if (isTaken)
            {
                taken++;
                Assert.True(Math.Abs(expected - actual) <= 1e-15 * (1e9 + Math.Abs(expected)) * 10.0, $"{date}: {expected:R}, {actual:R}");
            }
        }

        Assert.InRange(taken, count / 4, count / 2); // else nothing is compared
    }

    private static string RandomDate(Random random)
    {
        string Pick(params string[] of) => of[random.Next(of.Length)];
        string Number() => Pick($"{random.Next(1, 32)}", $"{random.Next(1, 13):00}", $"{random.Next(1, 13)}", $"{random.Next(32, 367)}");
        string Year() => Pick(
            $"{random.Next(1900, 2101)}", $"{random.Next(1900, 2101)}", Number(), $"{random.Next(1900, 2101)}{Pick("AD", "A.D.", "BC")}");
        string Time() => Pick(
            "12:30", "12:30:15", "1:2:3.5", "12:30.25", "12", "12.5", "23:59:60", "28:12:00:00", "12-30", "12-30-15.5");
        string Month() => Pick(Months);
        string Day() => Pick(Number(), Number(), Number() + ".6");
        switch (random.Next(20))
        {
            case < 3:
                string day = Year() + "-" + Number() + Pick("", "-" + Number(), "-" + Number());
                return day + "T" + Pick("", Time(), Time()) + Pick("", "", "Z");
            case 3:
                return Pick("", "JD", "-") + random.Next(2_500_000) + Pick(".5", "", ".", "JD", ".25JD");
            default:
                List<string> parts = random.Next(4) switch
                {
                    < 2 => [Year(), Month(), Day()],
                    2 => [Year(), Number(), Day()],
                    _ => [Year(), Number()],
                };
                bool isDayOfYear = parts.Count == 2;
                string[] shuffled = [.. parts];
                random.Shuffle(shuffled);
                parts = [.. shuffled];
                if (random.Next(10) < 7)
                {
                    parts.Insert(random.Next(2) == 0 ? parts.Count : random.Next(parts.Count + 1), Time());
                }

                string usual = Pick("-", "/", "-", ":");
                string date = parts[0];
                foreach (string part in parts.Skip(1))
                {
                    string separator = random.Next(5) > 0 ? usual : Pick("-", "/", ":", "", "::", "//");
                    date += (isDayOfYear && random.Next(2) == 0 ? Pick("//", "::", "/", "-") : separator) + part;
                }

                return (random.Next(20) == 0 ? Pick("TUE", "Sunday") : "") + date
                    + (isDayOfYear && random.Next(5) < 2 ? Pick("//", "::", "/") : "");
        }
    }
}
