using Msisf.Adapters.Ephemeris;

namespace Msisf.Adapters.Tests.Ephemeris;

/// <summary>Pools from the data part of a text kernel.</summary>
internal static class SamplePool
{
    public static KernelPool Of(string data)
    {
        KernelPool pool = new();
        TextKernelReader.Read(new StringReader("\\begindata\n" + data), "sample.tf", pool);
        return pool;
    }
}
