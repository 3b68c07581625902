KPL/MK

The kernels that MSISF loads with --body: leap seconds, the positions of the Sun and the planets, and the orientation of Mercury. For
another body write a meta-kernel like this one with its text kernel (and, for a moon, with its ephemeris), and name it with --kernels.

\begindata

KERNELS_TO_LOAD = ( 'naif0012.tls'
                    'mercury.tpc'
                    'de421.bsp' )

\begintext
