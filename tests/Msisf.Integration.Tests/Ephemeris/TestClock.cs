namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>A spacecraft's clock and frames, as text kernels.</summary>
internal static class TestClock
{
    public const int Clock = -999;
    public const int Instrument = -999000;
    public const double TicksPerSecond = 65536.0;

    /// <summary>Ticks of the first orientation; some time after the clock's third entry.</summary>
    public const double FirstTick = 3e6 * TicksPerSecond;

    /// <summary>Seconds of a tick at that time.</summary>
    public const double SecondsPerTick = 1.0000125 / TicksPerSecond;

    /// <summary>A clock that counts TT and has run at three rates.</summary>
    public const string Sclk =
        """
        KPL/SCLK
        \begindata
        SCLK_KERNEL_ID            = ( @2019-08-27/20:15:11.10 )
        SCLK_DATA_TYPE_999        = ( 1 )
        SCLK01_TIME_SYSTEM_999    = ( 2 )
        SCLK01_N_FIELDS_999       = ( 2 )
        SCLK01_MODULI_999         = ( 4294967296 65536 )
        SCLK01_OFFSETS_999        = ( 0 0 )
        SCLK01_OUTPUT_DELIM_999   = ( 1 )
        SCLK_PARTITION_START_999  = ( 0.0000000000000E+00 )
        SCLK_PARTITION_END_999    = ( 2.8147497671065E+14 )
        SCLK01_COEFFICIENTS_999   = ( 0.0D+00           2.990000000E+08  1.0000000000
                                      65536000000       3.000000100E+08  0.9999870000
                                      131072000000      3.010000000E+08  1.0000125000 )
        \begintext
        """;

    /// <summary>The spacecraft's frame, and that of a camera on it, by Euler angles.</summary>
    public const string Frames =
        """
        KPL/FK
        \begindata
        FRAME_TEST_SC             = -999000
        FRAME_-999000_NAME        = 'TEST_SC'
        FRAME_-999000_CLASS       = 3
        FRAME_-999000_CLASS_ID    = -999000
        FRAME_-999000_CENTER      = -999
        CK_-999000_SCLK           = -999
        CK_-999000_SPK            = -999
        FRAME_TEST_CAMERA         = -999100
        FRAME_-999100_NAME        = 'TEST_CAMERA'
        FRAME_-999100_CLASS       = 4
        FRAME_-999100_CLASS_ID    = -999100
        FRAME_-999100_CENTER      = -999
        TKFRAME_-999100_RELATIVE  = 'TEST_SC'
        TKFRAME_-999100_SPEC      = 'ANGLES'
        TKFRAME_-999100_UNITS     = 'DEGREES'
        TKFRAME_-999100_AXES      = ( 3, 1, 2 )
        TKFRAME_-999100_ANGLES    = ( 12.5, -3.25, 71.0 )
        NAIF_BODY_NAME           += ( 'TEST SATELLITE' )
        NAIF_BODY_CODE           += ( -999 )
        \begintext
        """;
}
